; made by `python -m release.loop --text` of sources 30e89c4bb9117481d667545b

@".const.Error creating Python tuple from runtime exception arguments" = internal constant [61 x i8] c"Error creating Python tuple from runtime exception arguments\00"
@".const.unknown error when calling native function" = internal constant [43 x i8] c"unknown error when calling native function\00"
@".const.<numba.core.cpu.CPUContext>" = internal constant [28 x i8] c"<numba.core.cpu.CPUContext>\00"
@PyExc_RuntimeError = external global i8
@PyExc_StopIteration = external global i8
@PyExc_SystemError = external global i8
define i32 @f68(ptr noalias writeonly %retptr, ptr noalias writeonly %excinfo, i64 %arg.address, i64 %arg.first_cycle, i64 %arg.cycles, i64 %arg.cycle_ticks, i64 %arg.numerator, i64 %arg.denominator) {
B0.endif.endif.endif.endi...endif.4.endif.endif:
  %.935 = alloca i64, align 8
  %excinfo.25 = alloca ptr, align 8
  store ptr null, ptr %excinfo.25, align 8
  %.10 = inttoptr i64 %arg.address to ptr
  %.46.i = load i64, ptr %.10, align 8
  %.47.i = inttoptr i64 %.46.i to ptr
  %0 = getelementptr i8, ptr %.10, i64 8
  %.77.i = load i64, ptr %0, align 8
  %1 = getelementptr i8, ptr %.10, i64 16
  %.107.i = load i64, ptr %1, align 8
  %.16.i.i = shl i64 %.107.i, 3
  %.25.i.i = mul nsw i64 %.107.i, %.77.i
  %2 = getelementptr i8, ptr %.10, i64 24
  %.46.i1 = load i64, ptr %2, align 8
  %.47.i2 = inttoptr i64 %.46.i1 to ptr
  %3 = getelementptr i8, ptr %.10, i64 32
  %.78.i = load i64, ptr %3, align 8
  %4 = getelementptr i8, ptr %.10, i64 48
  %.46.i4 = load i64, ptr %4, align 8
  %.47.i5 = inttoptr i64 %.46.i4 to ptr
  %5 = getelementptr i8, ptr %.10, i64 56
  %.77.i6 = load i64, ptr %5, align 8
  %6 = getelementptr i8, ptr %.10, i64 64
  %.107.i7 = load i64, ptr %6, align 8
  %.16.i.i8 = shl i64 %.107.i7, 3
  %.25.i.i9 = mul nsw i64 %.107.i7, %.77.i6
  %7 = getelementptr i8, ptr %.10, i64 72
  %.46.i17 = load i64, ptr %7, align 8
  %.47.i18 = inttoptr i64 %.46.i17 to ptr
  %8 = getelementptr i8, ptr %.10, i64 80
  %.77.i19 = load i64, ptr %8, align 8
  %9 = getelementptr i8, ptr %.10, i64 88
  %.107.i20 = load i64, ptr %9, align 8
  %.16.i.i21 = shl i64 %.107.i20, 3
  %.25.i.i22 = mul nsw i64 %.107.i20, %.77.i19
  %10 = getelementptr i8, ptr %.10, i64 96
  %.46.i30 = load i64, ptr %10, align 8
  %.47.i31 = inttoptr i64 %.46.i30 to ptr
  %11 = getelementptr i8, ptr %.10, i64 104
  %.78.i33 = load i64, ptr %11, align 8
  %12 = getelementptr i8, ptr %.10, i64 120
  %.46.i39 = load i64, ptr %12, align 8
  %.47.i40 = inttoptr i64 %.46.i39 to ptr
  %13 = getelementptr i8, ptr %.10, i64 128
  %.78.i42 = load i64, ptr %13, align 8
  %14 = getelementptr i8, ptr %.10, i64 144
  %.46.i48 = load i64, ptr %14, align 8
  %.47.i49 = inttoptr i64 %.46.i48 to ptr
  %15 = getelementptr i8, ptr %.10, i64 152
  %.78.i51 = load i64, ptr %15, align 8
  %16 = getelementptr i8, ptr %.10, i64 168
  %.46.i57 = load i64, ptr %16, align 8
  %.47.i58 = inttoptr i64 %.46.i57 to ptr
  %17 = getelementptr i8, ptr %.10, i64 176
  %.78.i60 = load i64, ptr %17, align 8
  %18 = getelementptr i8, ptr %.10, i64 192
  %.46.i66 = load i64, ptr %18, align 8
  %.47.i67 = inttoptr i64 %.46.i66 to ptr
  %19 = getelementptr i8, ptr %.10, i64 200
  %.78.i69 = load i64, ptr %19, align 8
  %20 = getelementptr i8, ptr %.10, i64 216
  %.46.i75 = load i64, ptr %20, align 8
  %.47.i76 = inttoptr i64 %.46.i75 to ptr
  %21 = getelementptr i8, ptr %.10, i64 224
  %.78.i78 = load i64, ptr %21, align 8
  %22 = getelementptr i8, ptr %.10, i64 240
  %.46.i84 = load i64, ptr %22, align 8
  %.47.i85 = inttoptr i64 %.46.i84 to ptr
  %23 = getelementptr i8, ptr %.10, i64 248
  %.78.i87 = load i64, ptr %23, align 8
  %24 = getelementptr i8, ptr %.10, i64 264
  %.46.i93 = load i64, ptr %24, align 8
  %.47.i94 = inttoptr i64 %.46.i93 to ptr
  %25 = getelementptr i8, ptr %.10, i64 272
  %.77.i95 = load i64, ptr %25, align 8
  %26 = getelementptr i8, ptr %.10, i64 280
  %.107.i96 = load i64, ptr %26, align 8
  %.16.i.i97 = shl i64 %.107.i96, 3
  %.25.i.i98 = mul nsw i64 %.107.i96, %.77.i95
  %27 = getelementptr i8, ptr %.10, i64 288
  %.46.i106 = load i64, ptr %27, align 8
  %.47.i107 = inttoptr i64 %.46.i106 to ptr
  %28 = getelementptr i8, ptr %.10, i64 296
  %.78.i109 = load i64, ptr %28, align 8
  %29 = getelementptr i8, ptr %.10, i64 312
  %.46.i115 = load i64, ptr %29, align 8
  %.47.i116 = inttoptr i64 %.46.i115 to ptr
  %30 = getelementptr i8, ptr %.10, i64 320
  %.78.i118 = load i64, ptr %30, align 8
  %31 = getelementptr i8, ptr %.10, i64 336
  %.46.i124 = load i64, ptr %31, align 8
  %.47.i125 = inttoptr i64 %.46.i124 to ptr
  %32 = getelementptr i8, ptr %.10, i64 344
  %.78.i127 = load i64, ptr %32, align 8
  %33 = getelementptr i8, ptr %.10, i64 360
  %.46.i133 = load i64, ptr %33, align 8
  %.47.i134 = inttoptr i64 %.46.i133 to ptr
  %34 = getelementptr i8, ptr %.10, i64 368
  %.78.i136 = load i64, ptr %34, align 8
  %35 = getelementptr i8, ptr %.10, i64 384
  %.46.i142 = load i64, ptr %35, align 8
  %.47.i143 = inttoptr i64 %.46.i142 to ptr
  %36 = getelementptr i8, ptr %.10, i64 392
  %.78.i145 = load i64, ptr %36, align 8
  %37 = getelementptr i8, ptr %.10, i64 408
  %.46.i151 = load i64, ptr %37, align 8
  %.47.i152 = inttoptr i64 %.46.i151 to ptr
  %38 = getelementptr i8, ptr %.10, i64 416
  %.78.i154 = load i64, ptr %38, align 8
  %39 = getelementptr i8, ptr %.10, i64 432
  %.46.i160 = load i64, ptr %39, align 8
  %.47.i161 = inttoptr i64 %.46.i160 to ptr
  %40 = getelementptr i8, ptr %.10, i64 440
  %.78.i163 = load i64, ptr %40, align 8
  %41 = getelementptr i8, ptr %.10, i64 456
  %.46.i169 = load i64, ptr %41, align 8
  %.47.i170 = inttoptr i64 %.46.i169 to ptr
  %42 = getelementptr i8, ptr %.10, i64 464
  %.78.i172 = load i64, ptr %42, align 8
  %43 = getelementptr i8, ptr %.10, i64 480
  %.46.i178 = load i64, ptr %43, align 8
  %.47.i179 = inttoptr i64 %.46.i178 to ptr
  %44 = getelementptr i8, ptr %.10, i64 488
  %.77.i180 = load i64, ptr %44, align 8
  %45 = getelementptr i8, ptr %.10, i64 496
  %.107.i181 = load i64, ptr %45, align 8
  %.16.i.i182 = shl i64 %.107.i181, 3
  %.25.i.i183 = mul nsw i64 %.107.i181, %.77.i180
  %46 = getelementptr i8, ptr %.10, i64 504
  %.46.i191 = load i64, ptr %46, align 8
  %.47.i192 = inttoptr i64 %.46.i191 to ptr
  %47 = getelementptr i8, ptr %.10, i64 512
  %.77.i193 = load i64, ptr %47, align 8
  %48 = getelementptr i8, ptr %.10, i64 520
  %.107.i194 = load i64, ptr %48, align 8
  %.16.i.i195 = shl i64 %.107.i194, 3
  %.25.i.i196 = mul nsw i64 %.107.i194, %.77.i193
  %49 = getelementptr i8, ptr %.10, i64 528
  %.46.i204 = load i64, ptr %49, align 8
  %.47.i205 = inttoptr i64 %.46.i204 to ptr
  %50 = getelementptr i8, ptr %.10, i64 536
  %.77.i206 = load i64, ptr %50, align 8
  %51 = getelementptr i8, ptr %.10, i64 544
  %.107.i207 = load i64, ptr %51, align 8
  %.16.i.i208 = shl i64 %.107.i207, 3
  %.25.i.i209 = mul nsw i64 %.107.i207, %.77.i206
  store i64 0, ptr %.935, align 8
  %.999 = call i32 @f69(ptr nonnull %.935, ptr nonnull %excinfo.25, ptr null, ptr null, i64 %.25.i.i, i64 8, ptr %.47.i, i64 %.77.i, i64 %.107.i, i64 %.16.i.i, i64 8, ptr null, ptr null, i64 %.78.i, i64 8, ptr %.47.i2, i64 %.78.i, i64 8, ptr null, ptr null, i64 %.25.i.i9, i64 8, ptr %.47.i5, i64 %.77.i6, i64 %.107.i7, i64 %.16.i.i8, i64 8, ptr null, ptr null, i64 %.25.i.i22, i64 8, ptr %.47.i18, i64 %.77.i19, i64 %.107.i20, i64 %.16.i.i21, i64 8, ptr null, ptr null, i64 %.78.i33, i64 8, ptr %.47.i31, i64 %.78.i33, i64 8, ptr null, ptr null, i64 %.78.i42, i64 8, ptr %.47.i40, i64 %.78.i42, i64 8, ptr null, ptr null, i64 %.78.i51, i64 1, ptr %.47.i49, i64 %.78.i51, i64 1, ptr null, ptr null, i64 %.78.i60, i64 4, ptr %.47.i58, i64 %.78.i60, i64 4, ptr null, ptr null, i64 %.78.i69, i64 1, ptr %.47.i67, i64 %.78.i69, i64 1, ptr null, ptr null, i64 %.78.i78, i64 8, ptr %.47.i76, i64 %.78.i78, i64 8, ptr null, ptr null, i64 %.78.i87, i64 8, ptr %.47.i85, i64 %.78.i87, i64 8, ptr null, ptr null, i64 %.25.i.i98, i64 8, ptr %.47.i94, i64 %.77.i95, i64 %.107.i96, i64 %.16.i.i97, i64 8, ptr null, ptr null, i64 %.78.i109, i64 8, ptr %.47.i107, i64 %.78.i109, i64 8, ptr null, ptr null, i64 %.78.i118, i64 8, ptr %.47.i116, i64 %.78.i118, i64 8, ptr null, ptr null, i64 %.78.i127, i64 8, ptr %.47.i125, i64 %.78.i127, i64 8, ptr null, ptr null, i64 %.78.i136, i64 8, ptr %.47.i134, i64 %.78.i136, i64 8, ptr null, ptr null, i64 %.78.i145, i64 8, ptr %.47.i143, i64 %.78.i145, i64 8, ptr null, ptr null, i64 %.78.i154, i64 8, ptr %.47.i152, i64 %.78.i154, i64 8, ptr null, ptr null, i64 %.78.i163, i64 8, ptr %.47.i161, i64 %.78.i163, i64 8, ptr null, ptr null, i64 %.78.i172, i64 8, ptr %.47.i170, i64 %.78.i172, i64 8, ptr null, ptr null, i64 %.25.i.i183, i64 8, ptr %.47.i179, i64 %.77.i180, i64 %.107.i181, i64 %.16.i.i182, i64 8, ptr null, ptr null, i64 %.25.i.i196, i64 8, ptr %.47.i192, i64 %.77.i193, i64 %.107.i194, i64 %.16.i.i195, i64 8, ptr null, ptr null, i64 %.25.i.i209, i64 8, ptr %.47.i205, i64 %.77.i206, i64 %.107.i207, i64 %.16.i.i208, i64 8, i64 %arg.first_cycle, i64 %arg.cycles, i64 %arg.cycle_ticks, i64 %arg.numerator, i64 %arg.denominator)
  %cond = icmp eq i32 %.999, 0
  br i1 %cond, label %B0.endif.endif.endif.endi...endif.4.endif.endif.endif, label %B0.endif.endif.endif.endi...endif.4.endif.endif.if.if
common.ret:                                       ; preds = %B0.endif.endif.endif.endi...endif.4.endif.endif.if.if, %B0.endif.endif.endif.endi...endif.4.endif.endif.endif
  ret i32 %.999
B0.endif.endif.endif.endi...endif.4.endif.endif.endif: ; preds = %B0.endif.endif.endif.endi...endif.4.endif.endif
  %.1009 = load i64, ptr %.935, align 8
  store i64 %.1009, ptr %retptr, align 8
  br label %common.ret
B0.endif.endif.endif.endi...endif.4.endif.endif.if.if: ; preds = %B0.endif.endif.endif.endi...endif.4.endif.endif
  %.1007 = icmp sgt i32 %.999, 0
  %.1000 = load ptr, ptr %excinfo.25, align 8
  %.1008 = select i1 %.1007, ptr %.1000, ptr undef
  store ptr %.1008, ptr %excinfo, align 8
  br label %common.ret
}
declare void @llvm.memset.p0.i64(ptr writeonly, i8, i64, i1 immarg)
declare void @numba_gil_ensure(ptr)
declare ptr @PyUnicode_FromString(ptr)
declare void @PyErr_WriteUnraisable(ptr)
declare void @Py_DecRef(ptr)
declare void @numba_gil_release(ptr)
declare void @PyErr_Clear()
declare ptr @PyBytes_FromStringAndSize(ptr, i64)
declare ptr @numba_unpickle(ptr, i32, ptr)
declare void @PyErr_SetString(ptr, ptr)
declare ptr @numba_runtime_build_excinfo_struct(ptr, ptr)
declare void @NRT_Free(ptr)
declare void @numba_do_raise(ptr)
declare void @PyErr_SetNone(ptr)
define linkonce_odr i32 @f69(ptr noalias writeonly %retptr, ptr noalias writeonly %excinfo, ptr readnone %arg.operations.0, ptr readnone %arg.operations.1, i64 %arg.operations.2, i64 %arg.operations.3, ptr readonly %arg.operations.4, i64 %arg.operations.5.0, i64 %arg.operations.5.1, i64 %arg.operations.6.0, i64 %arg.operations.6.1, ptr readnone %arg.coefficients.0, ptr readnone %arg.coefficients.1, i64 %arg.coefficients.2, i64 %arg.coefficients.3, ptr readonly %arg.coefficients.4, i64 %arg.coefficients.5.0, i64 %arg.coefficients.6.0, ptr readnone %arg.components.0, ptr readnone %arg.components.1, i64 %arg.components.2, i64 %arg.components.3, ptr readonly %arg.components.4, i64 %arg.components.5.0, i64 %arg.components.5.1, i64 %arg.components.6.0, i64 %arg.components.6.1, ptr readnone %arg.blocks.0, ptr readnone %arg.blocks.1, i64 %arg.blocks.2, i64 %arg.blocks.3, ptr readonly %arg.blocks.4, i64 %arg.blocks.5.0, i64 %arg.blocks.5.1, i64 %arg.blocks.6.0, i64 %arg.blocks.6.1, ptr readnone %arg.z.0, ptr readnone %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr readnone %arg.whole.0, ptr readnone %arg.whole.1, i64 %arg.whole.2, i64 %arg.whole.3, ptr %arg.whole.4, i64 %arg.whole.5.0, i64 %arg.whole.6.0, ptr readnone %arg.raw.0, ptr readnone %arg.raw.1, i64 %arg.raw.2, i64 %arg.raw.3, ptr %arg.raw.4, i64 %arg.raw.5.0, i64 %arg.raw.6.0, ptr readnone %arg.raw32.0, ptr readnone %arg.raw32.1, i64 %arg.raw32.2, i64 %arg.raw32.3, ptr %arg.raw32.4, i64 %arg.raw32.5.0, i64 %arg.raw32.6.0, ptr readnone %arg.pool.0, ptr readnone %arg.pool.1, i64 %arg.pool.2, i64 %arg.pool.3, ptr %arg.pool.4, i64 %arg.pool.5.0, i64 %arg.pool.6.0, ptr readnone %arg.index.0, ptr readnone %arg.index.1, i64 %arg.index.2, i64 %arg.index.3, ptr %arg.index.4, i64 %arg.index.5.0, i64 %arg.index.6.0, ptr readnone %arg.slots.0, ptr readnone %arg.slots.1, i64 %arg.slots.2, i64 %arg.slots.3, ptr readonly %arg.slots.4, i64 %arg.slots.5.0, i64 %arg.slots.6.0, ptr readnone %arg.groups.0, ptr readnone %arg.groups.1, i64 %arg.groups.2, i64 %arg.groups.3, ptr readonly %arg.groups.4, i64 %arg.groups.5.0, i64 %arg.groups.5.1, i64 %arg.groups.6.0, i64 %arg.groups.6.1, ptr readnone %arg.buffer.0, ptr readnone %arg.buffer.1, i64 %arg.buffer.2, i64 %arg.buffer.3, ptr writeonly %arg.buffer.4, i64 %arg.buffer.5.0, i64 %arg.buffer.6.0, ptr readnone %arg.rows.0, ptr readnone %arg.rows.1, i64 %arg.rows.2, i64 %arg.rows.3, ptr %arg.rows.4, i64 %arg.rows.5.0, i64 %arg.rows.6.0, ptr readnone %arg.control.0, ptr readnone %arg.control.1, i64 %arg.control.2, i64 %arg.control.3, ptr %arg.control.4, i64 %arg.control.5.0, i64 %arg.control.6.0, ptr readnone %arg.clock.0, ptr readnone %arg.clock.1, i64 %arg.clock.2, i64 %arg.clock.3, ptr %arg.clock.4, i64 %arg.clock.5.0, i64 %arg.clock.6.0, ptr readnone %arg.work.0, ptr readnone %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0, ptr readnone %arg.saved.0, ptr readnone %arg.saved.1, i64 %arg.saved.2, i64 %arg.saved.3, ptr %arg.saved.4, i64 %arg.saved.5.0, i64 %arg.saved.6.0, ptr readnone %arg.solver.0, ptr readnone %arg.solver.1, i64 %arg.solver.2, i64 %arg.solver.3, ptr %arg.solver.4, i64 %arg.solver.5.0, i64 %arg.solver.6.0, ptr readnone %arg.states.0, ptr readnone %arg.states.1, i64 %arg.states.2, i64 %arg.states.3, ptr %arg.states.4, i64 %arg.states.5.0, i64 %arg.states.6.0, ptr readnone %arg.state_calls.0, ptr readnone %arg.state_calls.1, i64 %arg.state_calls.2, i64 %arg.state_calls.3, ptr readonly %arg.state_calls.4, i64 %arg.state_calls.5.0, i64 %arg.state_calls.5.1, i64 %arg.state_calls.6.0, i64 %arg.state_calls.6.1, ptr readnone %arg.moves.0, ptr readnone %arg.moves.1, i64 %arg.moves.2, i64 %arg.moves.3, ptr readonly %arg.moves.4, i64 %arg.moves.5.0, i64 %arg.moves.5.1, i64 %arg.moves.6.0, i64 %arg.moves.6.1, ptr readnone %arg.turns.0, ptr readnone %arg.turns.1, i64 %arg.turns.2, i64 %arg.turns.3, ptr readonly %arg.turns.4, i64 %arg.turns.5.0, i64 %arg.turns.5.1, i64 %arg.turns.6.0, i64 %arg.turns.6.1, i64 %arg.first_cycle, i64 %arg.cycles, i64 %arg.cycle_ticks, i64 %arg.numerator, i64 %arg.denominator) {
B0:
  %.2846 = alloca i64, align 8
  store i64 0, ptr %.2846, align 8
  %excinfo.5 = alloca ptr, align 8
  store ptr null, ptr %excinfo.5, align 8
  %.3597 = alloca i64, align 8
  store i64 0, ptr %.3597, align 8
  %excinfo.8 = alloca ptr, align 8
  store ptr null, ptr %excinfo.8, align 8
  %.4529 = alloca i64, align 8
  store i64 0, ptr %.4529, align 8
  %excinfo.10 = alloca ptr, align 8
  store ptr null, ptr %excinfo.10, align 8
  %.9112 = alloca double, align 8
  store double 0.000000e+00, ptr %.9112, align 8
  %excinfo.14 = alloca ptr, align 8
  store ptr null, ptr %excinfo.14, align 8
  %.10592 = alloca i64, align 8
  store i64 0, ptr %.10592, align 8
  %excinfo.23 = alloca ptr, align 8
  store ptr null, ptr %excinfo.23, align 8
  %.10984 = alloca i64, align 8
  store i64 0, ptr %.10984, align 8
  %excinfo.24 = alloca ptr, align 8
  store ptr null, ptr %excinfo.24, align 8
  %.11432 = alloca double, align 8
  store double 0.000000e+00, ptr %.11432, align 8
  %excinfo.26 = alloca ptr, align 8
  store ptr null, ptr %excinfo.26, align 8
  %.11964 = alloca i64, align 8
  store i64 0, ptr %.11964, align 8
  %excinfo.27 = alloca ptr, align 8
  store ptr null, ptr %excinfo.27, align 8
  %.13133 = alloca i64, align 8
  store i64 0, ptr %.13133, align 8
  %excinfo.31 = alloca ptr, align 8
  store ptr null, ptr %excinfo.31, align 8
  %.14686 = alloca double, align 8
  store double 0.000000e+00, ptr %.14686, align 8
  %excinfo.34 = alloca ptr, align 8
  store ptr null, ptr %excinfo.34, align 8
  %.15301 = alloca i64, align 8
  store i64 0, ptr %.15301, align 8
  %excinfo.36 = alloca ptr, align 8
  store ptr null, ptr %excinfo.36, align 8
  %.328 = getelementptr i8, ptr %arg.control.4, i64 48
  %.329 = load i64, ptr %.328, align 8
  %.330 = icmp sgt i64 %.329, 0
  br i1 %.330, label %B38, label %B116.endif
B38:                                              ; preds = %B0
  %.360 = getelementptr i8, ptr %arg.control.4, i64 64
  %.361 = load i64, ptr %.360, align 8
  %.392 = add nsw i64 %.361, %.329
  %.394 = mul nsw i64 %.392, %arg.numerator
  %.396 = sitofp i64 %.394 to double
  %.397 = sitofp i64 %arg.denominator to double
  %.401 = fdiv double %.396, %.397
  br label %B116.endif
B206:                                             ; preds = %B206.lr.ph, %B10352
  %.509.0 = phi i64 [ %arg.first_cycle, %B206.lr.ph ], [ %.581, %B10352 ]
  %.56711337 = phi i64 [ %arg.cycles, %B206.lr.ph ], [ %.577, %B10352 ]
  %begin.2.011335 = phi i64 [ %.444, %B206.lr.ph ], [ 0, %B10352 ]
  %.577 = add nsw i64 %.56711337, -1
  %.581 = add i64 %.509.0, 1
  %.641 = mul nsw i64 %.509.0, %arg.cycle_ticks
  %.735 = icmp slt i64 %begin.2.011335, %arg.operations.5.0
  br i1 %.735, label %B362.preheader, label %B10212
B362.preheader:                                   ; preds = %B206
  %.712 = add nsw i64 %begin.2.011335, -1
  %sunkaddr630 = getelementptr i8, ptr %arg.control.4, i64 64
  %.638 = load i64, ptr %sunkaddr630, align 8
  %.642 = add nsw i64 %.638, %.641
  %.672 = load i64, ptr %arg.clock.4, align 8
  %.673 = add nsw i64 %.642, %.672
  %sunkaddr631 = getelementptr i8, ptr %arg.clock.4, i64 48
  %.703 = load i64, ptr %sunkaddr631, align 8
  %.704 = add nsw i64 %.673, %.703
  br label %B362
B362:                                             ; preds = %B10170, %B362.preheader
  %base.3.1 = phi i64 [ %base.4.3, %B10170 ], [ %.704, %B362.preheader ]
  %last_tick.2.1 = phi i64 [ %last_tick.3.3, %B10170 ], [ -1, %B362.preheader ]
  %m.6.1 = phi i64 [ %m.7.3, %B10170 ], [ %.712, %B362.preheader ]
  %.745 = add nsw i64 %m.6.1, 1
  %.778 = icmp slt i64 %m.6.1, -1
  %.779 = select i1 %.778, i64 %arg.operations.5.0, i64 0
  %.780 = add i64 %.779, %.745
  %.800 = mul i64 %.780, %arg.operations.5.1
  %.804 = getelementptr i64, ptr %arg.operations.4, i64 %.800
  %.805 = load i64, ptr %.804, align 8
  %.859 = getelementptr i8, ptr %.804, i64 8
  %.860 = load i64, ptr %.859, align 8
  %.914 = getelementptr i8, ptr %.804, i64 16
  %.915 = load i64, ptr %.914, align 8
  %.978 = getelementptr i8, ptr %.804, i64 24
  %.979 = load i64, ptr %.978, align 8
  %.1033 = getelementptr i8, ptr %.804, i64 32
  %.1034 = load i64, ptr %.1033, align 8
  %.1088 = getelementptr i8, ptr %.804, i64 40
  %.1089 = load i64, ptr %.1088, align 8
  %.1152 = getelementptr i8, ptr %.804, i64 48
  %.1153 = load i64, ptr %.1152, align 8
  %.1207 = getelementptr i8, ptr %.804, i64 56
  %.1208 = load i64, ptr %.1207, align 8
  %.1217.not = icmp eq i64 %.860, %last_tick.2.1
  br i1 %.1217.not, label %B742, label %B544
B544:                                             ; preds = %B362
  %.1256 = load i64, ptr %arg.control.4, align 8
  %.1257.not = icmp eq i64 %.1256, 0
  br i1 %.1257.not, label %B642, label %B582
common.ret:                                       ; preds = %B9994.if.if, %B9328.if.if, %B8220.if.if, %B7386.endif.if.if, %B7000.endif.if.if, %B6650.endif.if.if, %B6464.if.if, %B5478.endif.endif.if.if, %B2608.if.if, %B2050.if.if, %B1560.if.if, %B10356, %B10334, %B10120, %B8590, %B8422, %B7742, %B6772, %B6564, %B6300, %B4420, %B2870, %B2708, %B2488, %B2172, %B1614, %B1086, %B682, %B582
  %common.ret.op = phi i32 [ 0, %B582 ], [ 0, %B682 ], [ 0, %B1086 ], [ 0, %B1614 ], [ 0, %B2172 ], [ 0, %B2488 ], [ 0, %B2708 ], [ 0, %B2870 ], [ 0, %B4420 ], [ 0, %B6300 ], [ 0, %B6564 ], [ 0, %B6772 ], [ 0, %B7742 ], [ 0, %B8422 ], [ 0, %B8590 ], [ 0, %B10120 ], [ 0, %B10334 ], [ 0, %B10356 ], [ %.10994, %B6650.endif.if.if ], [ %.15307, %B9994.if.if ], [ %.9118, %B5478.endif.endif.if.if ], [ %.14690, %B9328.if.if ], [ %.2864, %B1560.if.if ], [ %.10602, %B6464.if.if ], [ %.11976, %B7386.endif.if.if ], [ %.3617, %B2050.if.if ], [ %.13137, %B8220.if.if ], [ %.4551, %B2608.if.if ], [ %.11442, %B7000.endif.if.if ]
  ret i32 %common.ret.op
B582:                                             ; preds = %B544
  %.1364 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.1364, align 8
  %.1397 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.1397, align 8
  store i64 1, ptr %retptr, align 8
  br label %common.ret
B642:                                             ; preds = %B544
  %.1412 = add nsw i64 %.860, %base.3.1
  %sunkaddr632 = getelementptr i8, ptr %arg.control.4, i64 56
  %.1442 = load i64, ptr %sunkaddr632, align 8
  %.1443 = icmp sgt i64 %.1412, %.1442
  br i1 %.1443, label %B682, label %B742
B682:                                             ; preds = %B642
  %.1550 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.1550, align 8
  %.1583 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.1583, align 8
  store i64 5, ptr %retptr, align 8
  br label %common.ret
B742:                                             ; preds = %B642, %B362
  %last_tick.3.3 = phi i64 [ %.860, %B642 ], [ %last_tick.2.1, %B362 ]
  switch i64 %.805, label %B5686 [
    i64 4, label %B764
    i64 5, label %B1204
    i64 3, label %B1204
    i64 38, label %B2608
    i64 39, label %B2784.endif
    i64 37, label %B2988
    i64 0, label %B3052
    i64 1, label %B3142
    i64 7, label %B3292
    i64 35, label %B3398
    i64 2, label %B3504
    i64 9, label %B3704
    i64 6, label %B3704
    i64 27, label %B3752
    i64 28, label %B3956
    i64 8, label %B4506.endif
    i64 12, label %B4730
    i64 13, label %B4956
    i64 10, label %B5054
    i64 11, label %B5300
    i64 21, label %B5478
    i64 22, label %B5624
  ]
B764:                                             ; preds = %B742
  %.1606 = add nsw i64 %.1034, %base.3.1
  %.1610 = mul nsw i64 %.1606, %arg.numerator
  %.1612 = sitofp i64 %.1610 to double
  %.1617 = fdiv double %.1612, %.9206
  %sunkaddr633 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.1650 = load i64, ptr %sunkaddr633, align 8
  %.1652 = add nsw i64 %.1650, %.979
  %.1656 = mul nsw i64 %.1652, %arg.numerator
  %.1658 = sitofp i64 %.1656 to double
  %.1663 = fdiv double %.1658, %.9206
  %.1668 = fadd double %.1617, %.1663
  %.1670 = fcmp ogt double %.1668, %"$phi116.0.2.0"
  br i1 %.1670, label %B852, label %B884
B852:                                             ; preds = %B764
  %.12.i = fsub double %"$phi116.0.2.0", %.1617
  %.20.i = fadd double %.1617, %.12.i
  %.22.i = fcmp ogt double %.20.i, %"$phi116.0.2.0"
  br i1 %.22.i, label %B32.i.preheader, label %B884
B32.i.preheader:                                  ; preds = %B852
  br label %B32.i
B32.i:                                            ; preds = %B32.i.preheader, %B32.i
  %length.2.0.i = phi double [ %.25.i, %B32.i ], [ %.12.i, %B32.i.preheader ]
  %.25.i = fmul double %length.2.0.i, 0x3FEFFFFFFFFFFFFE
  %.31.i = fadd double %.1617, %.25.i
  %.33.i = fcmp ogt double %.31.i, %"$phi116.0.2.0"
  br i1 %.33.i, label %B32.i, label %B884
B884:                                             ; preds = %B32.i, %B852, %B764
  %length.6.3 = phi double [ %.1663, %B764 ], [ %.12.i, %B852 ], [ %.25.i, %B32.i ]
  %.1728 = icmp slt i64 %.915, 0
  %.1729 = select i1 %.1728, i64 %arg.components.5.0, i64 0
  %.1730 = add i64 %.1729, %.915
  %.1750 = mul i64 %.1730, %arg.components.5.1
  %.1754 = getelementptr i64, ptr %arg.components.4, i64 %.1750
  %.1755 = load i64, ptr %.1754, align 8
  %.1809 = getelementptr i8, ptr %.1754, i64 16
  %.1810 = load i64, ptr %.1809, align 8
  %.1864 = getelementptr i8, ptr %.1754, i64 8
  %.1865 = load i64, ptr %.1864, align 8
  %.1919 = getelementptr i8, ptr %.1754, i64 64
  %.1920 = load i64, ptr %.1919, align 8
  %.23.i = icmp eq i64 %.1755, 2
  br i1 %.23.i, label %B884.endif, label %B54.endif.i
B54.endif.i:                                      ; preds = %B884
  %0 = inttoptr i64 %.1810 to ptr
  %sunkaddr1172 = shl i64 %.1750, 3
  %sunkaddr1173 = getelementptr i8, ptr %arg.components.4, i64 %sunkaddr1172
  %sunkaddr1174 = getelementptr i8, ptr %sunkaddr1173, i64 24
  %.1977 = load i64, ptr %sunkaddr1174, align 8
  %.12.i2.i = inttoptr i64 %.1977 to ptr
  %.13.i.i = add i64 %.1977, 1
  %.14.i.i = inttoptr i64 %.13.i.i to ptr
  %.15.i.i = add i64 %.1977, 2
  %.16.i.i = inttoptr i64 %.15.i.i to ptr
  %.17.i.i = add i64 %.1977, 8
  %.18.i.i = inttoptr i64 %.17.i.i to ptr
  store i8 0, ptr %.12.i2.i, align 1
  store i8 0, ptr %.14.i.i, align 1
  store i8 0, ptr %.16.i.i, align 1
  %.22.i.i = trunc i64 %.1920 to i32
  %.23.i.i = inttoptr i64 %.1865 to ptr
  %.24.i.i = tail call i32 %0(ptr %.23.i.i, double %.1617, double %length.6.3, i32 %.22.i.i, ptr nonnull %.12.i2.i, ptr nonnull %.14.i.i, ptr nonnull %.16.i.i, ptr %.18.i.i)
  %.7.i9.i = icmp ugt i32 %.24.i.i, 1
  br i1 %.7.i9.i, label %B1086.split.loop.exit638, label %B124.endif.i
B124.endif.i:                                     ; preds = %B54.endif.i
  %1 = inttoptr i64 %.13.i.i to ptr
  %const623 = bitcast i64 1099511627776 to i64
  %.6.i.i = load i8, ptr %1, align 1
  %.175.not.i = icmp eq i8 %.6.i.i, 0
  %const_mat624 = add i64 %const623, 1
  br i1 %.175.not.i, label %B182.endif.i, label %B1086
B182.endif.i:                                     ; preds = %B124.endif.i
  %2 = inttoptr i64 %.15.i.i to ptr
  %.6.i4.i = load i8, ptr %2, align 1
  %.209.not.i = icmp eq i8 %.6.i4.i, 0
  %const_mat625 = add i64 %const623, 2
  br i1 %.209.not.i, label %B240.endif.i, label %B1086
B240.endif.i:                                     ; preds = %B182.endif.i
  %3 = inttoptr i64 %.1977 to ptr
  %.6.i7.i = load i8, ptr %3, align 1
  %.244.not.i = icmp eq i8 %.6.i7.i, 0
  br i1 %.244.not.i, label %B10170, label %B1086
B1086.split.loop.exit638:                         ; preds = %B884.endif, %B54.endif.i
  %.68.sink.i.in732 = phi i32 [ %.12.i.i, %B884.endif ], [ %.24.i.i, %B54.endif.i ]
  %.68.sink.i.le = sext i32 %.68.sink.i.in732 to i64
  br label %B1086
B1086:                                            ; preds = %B240.endif.i, %B182.endif.i, %B124.endif.i, %B1086.split.loop.exit638
  %.68.sink.i536 = phi i64 [ %.68.sink.i.le, %B1086.split.loop.exit638 ], [ %const_mat624, %B124.endif.i ], [ %const623, %B240.endif.i ], [ %const_mat625, %B182.endif.i ]
  %.2135 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.2135, align 8
  %.2168 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.2168, align 8
  %.2201 = getelementptr i8, ptr %arg.control.4, i64 24
  store i64 %.68.sink.i536, ptr %.2201, align 8
  store i64 2, ptr %retptr, align 8
  br label %common.ret
B1204:                                            ; preds = %B742, %B742
  %4 = icmp eq i64 %.805, 5
  %.2304 = icmp slt i64 %.915, 0
  %.2305 = select i1 %.2304, i64 %arg.components.5.0, i64 0
  %.2306 = add i64 %.2305, %.915
  %.2326 = mul i64 %.2306, %arg.components.5.1
  %5 = getelementptr i64, ptr %arg.components.4, i64 %.2326
  %.2330 = getelementptr i8, ptr %5, i64 32
  %.2385 = getelementptr i8, ptr %5, i64 40
  br i1 %4, label %B1286, label %B1452.endif
B1286:                                            ; preds = %B1204
  %.2397 = icmp eq i64 %.979, 2
  br i1 %.2397, label %B1308, label %B1392
B1308:                                            ; preds = %B1286
  %.2458 = getelementptr i8, ptr %5, i64 72
  %.2513 = getelementptr i8, ptr %5, i64 80
  br label %B1452.endif
B1392:                                            ; preds = %B1286
  %.2590 = getelementptr i8, ptr %5, i64 48
  %.2645 = getelementptr i8, ptr %5, i64 56
  br label %B1452.endif
B1488:                                            ; preds = %B1488.preheader, %B2578
  %.27371124011280 = phi i64 [ %.2747, %B2578 ], [ %.2694, %B1488.preheader ]
  %.27441124811279 = phi i64 [ %.2751, %B2578 ], [ %first.4.4, %B1488.preheader ]
  %6 = icmp eq i64 %.805, 3
  %.2747 = add nsw i64 %.27371124011280, -1
  %.2751 = add i64 %.27441124811279, 1
  br i1 %6, label %B1512, label %B1698
B1512:                                            ; preds = %B1488
  %.2809 = icmp slt i64 %.27441124811279, 0
  %.2810 = select i1 %.2809, i64 %arg.blocks.5.0, i64 0
  %.2811 = add i64 %.2810, %.27441124811279
  %.2831 = mul i64 %.2811, %arg.blocks.5.1
  %7 = getelementptr i64, ptr %arg.blocks.4, i64 %.2831
  %.2835 = getelementptr i8, ptr %7, i64 48
  %.2836 = load i64, ptr %.2835, align 8
  %.2837.not = icmp eq i64 %.2836, -1
  br i1 %.2837.not, label %B1698, label %B1560
B1560:                                            ; preds = %B1512
  store i64 0, ptr %.2846, align 8
  %.2864 = call i32 @f70(ptr nonnull %.2846, ptr nonnull %excinfo.5, ptr %arg.blocks.0, ptr %arg.blocks.1, i64 %arg.blocks.2, i64 %arg.blocks.3, ptr nonnull %arg.blocks.4, i64 %arg.blocks.5.0, i64 %arg.blocks.5.1, i64 %arg.blocks.6.0, i64 %arg.blocks.6.1, i64 %.27441124811279, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr %arg.whole.0, ptr %arg.whole.1, i64 %arg.whole.2, i64 %arg.whole.3, ptr %arg.whole.4, i64 %arg.whole.5.0, i64 %arg.whole.6.0, ptr %arg.raw.0, ptr %arg.raw.1, i64 %arg.raw.2, i64 %arg.raw.3, ptr %arg.raw.4, i64 %arg.raw.5.0, i64 %arg.raw.6.0, ptr %arg.raw32.0, ptr %arg.raw32.1, i64 %arg.raw32.2, i64 %arg.raw32.3, ptr %arg.raw32.4, i64 %arg.raw32.5.0, i64 %arg.raw32.6.0, ptr %arg.index.0, ptr %arg.index.1, i64 %arg.index.2, i64 %arg.index.3, ptr %arg.index.4, i64 %arg.index.5.0, i64 %arg.index.6.0)
  %cond551 = icmp eq i32 %.2864, 0
  br i1 %cond551, label %B1560.endif, label %B1560.if.if
B1614:                                            ; preds = %B1560.endif
  %.2987 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.2987, align 8
  %.3020 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.3020, align 8
  %sunkaddr1175 = getelementptr i8, ptr %arg.control.4, i64 32
  store i64 %.2874, ptr %sunkaddr1175, align 8
  store i64 6, ptr %retptr, align 8
  br label %common.ret
B1698:                                            ; preds = %B1488, %B1560.endif, %B1512
  %.3090 = icmp slt i64 %.27441124811279, 0
  %.3091 = select i1 %.3090, i64 %arg.blocks.5.0, i64 0
  %.3092 = add i64 %.3091, %.27441124811279
  %.3112 = mul i64 %.3092, %arg.blocks.5.1
  %.3116 = getelementptr i64, ptr %arg.blocks.4, i64 %.3112
  %.3117 = load i64, ptr %.3116, align 8
  %sunkaddr634 = getelementptr i8, ptr %5, i64 8
  %.3172 = load i64, ptr %sunkaddr634, align 8
  %.3226 = getelementptr i8, ptr %.3116, i64 8
  %.3227 = load i64, ptr %.3226, align 8
  %.3281 = getelementptr i8, ptr %.3116, i64 16
  %.3282 = load i64, ptr %.3281, align 8
  %.3336 = getelementptr i8, ptr %.3116, i64 24
  %.3337 = load i64, ptr %.3336, align 8
  %.3391 = getelementptr i8, ptr %.3116, i64 32
  %.3392 = load i64, ptr %.3391, align 8
  %.3447 = load i64, ptr %5, align 8
  %.23.i437 = icmp eq i64 %.3447, 2
  br i1 %.23.i437, label %B16.endif.i442, label %B54.i
B54.i:                                            ; preds = %B1698
  %.71.i = icmp slt i64 %.3117, 0
  br i1 %.71.i, label %B66.endif.i, label %B122.endif.i
B16.endif.i442:                                   ; preds = %B1698
  %.9.i.i = inttoptr i64 %.3117 to ptr
  %.10.i.i443 = inttoptr i64 %.3172 to ptr
  %.11.i.i444 = inttoptr i64 %.3227 to ptr
  %.12.i.i445 = inttoptr i64 %.3337 to ptr
  %.13.i.i446 = tail call i32 %.9.i.i(ptr %.10.i.i443, ptr %.11.i.i444, i64 %.3282, ptr %.12.i.i445)
  br label %B1698.endif
B66.endif.i:                                      ; preds = %B54.i
  %.74.i = sub i64 0, %.3117
  %.78.i = shl nsw i64 %.3392, 3
  %.80.i = add nsw i64 %.78.i, %.3337
  %.11.i1.i = inttoptr i64 %.74.i to ptr
  %.12.i2.i438 = inttoptr i64 %.3172 to ptr
  %.13.i3.i = inttoptr i64 %.3227 to ptr
  %.14.i.i439 = inttoptr i64 %.80.i to ptr
  %.15.i.i440 = inttoptr i64 %.3337 to ptr
  %.16.i.i441 = tail call i32 %.11.i1.i(ptr %.12.i2.i438, ptr %.13.i3.i, i64 %.3282, ptr %.14.i.i439, ptr %.15.i.i440, i64 %.3392)
  br label %B1698.endif
B122.endif.i:                                     ; preds = %B54.i
  %.10.i4.i = inttoptr i64 %.3117 to ptr
  %.11.i5.i = inttoptr i64 %.3172 to ptr
  %.12.i6.i = inttoptr i64 %.3227 to ptr
  %.13.i7.i = inttoptr i64 %.3337 to ptr
  %.14.i8.i = tail call i32 %.10.i4.i(ptr %.11.i5.i, ptr %.12.i6.i, i64 %.3282, ptr %.13.i7.i, i64 %.3392)
  br label %B1698.endif
B1980:                                            ; preds = %B1698.endif
  %8 = icmp eq i64 %.805, 5
  br i1 %8, label %B2002, label %B2578
B2002:                                            ; preds = %B1980
  %sunkaddr1177 = shl i64 %.3112, 3
  %sunkaddr1178 = getelementptr i8, ptr %arg.blocks.4, i64 %sunkaddr1177
  %sunkaddr1179 = getelementptr i8, ptr %sunkaddr1178, i64 48
  %.3580 = load i64, ptr %sunkaddr1179, align 8
  %.3581.not = icmp eq i64 %.3580, -1
  br i1 %.3581.not, label %B2278, label %B2050
B2050:                                            ; preds = %B2002
  store i64 0, ptr %.3597, align 8
  %.3617 = call i32 @f71(ptr nonnull %.3597, ptr nonnull %excinfo.8, ptr %arg.blocks.0, ptr %arg.blocks.1, i64 %arg.blocks.2, i64 %arg.blocks.3, ptr nonnull %arg.blocks.4, i64 %arg.blocks.5.0, i64 %arg.blocks.5.1, i64 %arg.blocks.6.0, i64 %arg.blocks.6.1, i64 %.27441124811279, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr %arg.whole.0, ptr %arg.whole.1, i64 %arg.whole.2, i64 %arg.whole.3, ptr %arg.whole.4, i64 %arg.whole.5.0, i64 %arg.whole.6.0, ptr %arg.raw.0, ptr %arg.raw.1, i64 %arg.raw.2, i64 %arg.raw.3, ptr %arg.raw.4, i64 %arg.raw.5.0, i64 %arg.raw.6.0, ptr %arg.raw32.0, ptr %arg.raw32.1, i64 %arg.raw32.2, i64 %arg.raw32.3, ptr %arg.raw32.4, i64 %arg.raw32.5.0, i64 %arg.raw32.6.0, ptr %arg.pool.0, ptr %arg.pool.1, i64 %arg.pool.2, i64 %arg.pool.3, ptr %arg.pool.4, i64 %arg.pool.5.0, i64 %arg.pool.6.0, ptr %arg.index.0, ptr %arg.index.1, i64 %arg.index.2, i64 %arg.index.3, ptr %arg.index.4, i64 %arg.index.5.0, i64 %arg.index.6.0)
  %cond550 = icmp eq i32 %.3617, 0
  br i1 %cond550, label %B2050.endif, label %B2050.if.if
B2142.thread:                                     ; preds = %B2050.endif
  %const = bitcast i64 1099511627776 to i64
  %sunkaddr1180 = getelementptr i8, ptr %arg.control.4, i64 32
  store i64 %.3627, ptr %sunkaddr1180, align 8
  %const_mat = add i64 %const, 3
  br label %B2172
B2172.loopexit:                                   ; preds = %B1698.endif
  %.3476.le = sext i32 %.14.i8.sink.i to i64
  br label %B2172
B2172:                                            ; preds = %B2172.loopexit, %B2142.thread
  %status.8.5527 = phi i64 [ %const_mat, %B2142.thread ], [ %.3476.le, %B2172.loopexit ]
  %.3815 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.3815, align 8
  %.3848 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.3848, align 8
  %.3881 = getelementptr i8, ptr %arg.control.4, i64 24
  store i64 %status.8.5527, ptr %.3881, align 8
  store i64 2, ptr %retptr, align 8
  br label %common.ret
B2278:                                            ; preds = %B2050.endif, %B2002
  %sunkaddr635 = mul i64 %.3112, 8
  %sunkaddr636 = getelementptr i8, ptr %arg.blocks.4, i64 %sunkaddr635
  %sunkaddr637 = getelementptr i8, ptr %sunkaddr636, i64 56
  %.3948 = load i64, ptr %sunkaddr637, align 8
  %.3949 = icmp eq i64 %.3948, 0
  br i1 %.3949, label %B2326.endif, label %B2578
B2442:                                            ; preds = %B2326.endif, %B2444
  %.420411232 = phi i64 [ %.4211, %B2444 ], [ %.4005, %B2326.endif ]
  %.419711231 = phi i64 [ %.4207, %B2444 ], [ %..4117, %B2326.endif ]
  %.4198 = icmp sgt i64 %.419711231, 0
  br i1 %.4198, label %B2444, label %B2578
B2444:                                            ; preds = %B2442
  %.4207 = add nsw i64 %.419711231, -1
  %.4211 = add i64 %.420411232, 1
  %.4253 = icmp slt i64 %.420411232, 0
  %9 = select i1 %.4253, i64 %173, i64 0
  %scevgep1109 = getelementptr i8, ptr %arg.z.4, i64 %9
  %10 = shl i64 %.420411232, 3
  %scevgep1110 = getelementptr i8, ptr %scevgep1109, i64 %10
  %.4269 = load double, ptr %scevgep1110, align 8
  %.4270 = fsub double %.4269, %.4269
  %.4271 = fcmp ord double %.4270, 0.000000e+00
  br i1 %.4271, label %B2442, label %B2488
B2488:                                            ; preds = %B2444
  %.4370 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.4370, align 8
  %.4403 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.4403, align 8
  %sunkaddr1184 = getelementptr i8, ptr %arg.control.4, i64 32
  %11 = add i64 %.4211, -1
  store i64 %11, ptr %sunkaddr1184, align 8
  store i64 3, ptr %retptr, align 8
  br label %common.ret
B2578:                                            ; preds = %B2442, %B2278, %B1980
  %.2738 = icmp sgt i64 %.27371124011280, 1
  br i1 %.2738, label %B1488, label %B10170
B2608:                                            ; preds = %B742
  %sunkaddr638 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.4515 = load i64, ptr %sunkaddr638, align 8
  store i64 0, ptr %.4529, align 8
  %.4551 = call i32 @f72(ptr nonnull %.4529, ptr nonnull %excinfo.10, ptr %arg.turns.0, ptr %arg.turns.1, i64 %arg.turns.2, i64 %arg.turns.3, ptr %arg.turns.4, i64 %arg.turns.5.0, i64 %arg.turns.5.1, i64 %arg.turns.6.0, i64 %arg.turns.6.1, i64 %.979, i64 %.1034, ptr %arg.moves.0, ptr %arg.moves.1, i64 %arg.moves.2, i64 %arg.moves.3, ptr %arg.moves.4, i64 %arg.moves.5.0, i64 %arg.moves.5.1, i64 %arg.moves.6.0, i64 %arg.moves.6.1, i64 %.1089, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr %arg.coefficients.0, ptr %arg.coefficients.1, i64 %arg.coefficients.2, i64 %arg.coefficients.3, ptr %arg.coefficients.4, i64 %arg.coefficients.5.0, i64 %arg.coefficients.6.0, ptr %arg.components.0, ptr %arg.components.1, i64 %arg.components.2, i64 %arg.components.3, ptr %arg.components.4, i64 %arg.components.5.0, i64 %arg.components.5.1, i64 %arg.components.6.0, i64 %arg.components.6.1, ptr %arg.control.0, ptr %arg.control.1, i64 %arg.control.2, i64 %arg.control.3, ptr %arg.control.4, i64 %arg.control.5.0, i64 %arg.control.6.0, i64 %base.3.1, i64 %.4515, i64 %arg.numerator, i64 %arg.denominator, double %"$phi116.0.2.0")
  %cond549 = icmp eq i32 %.4551, 0
  br i1 %cond549, label %B2608.endif, label %B2608.if.if
B2708:                                            ; preds = %B2608.endif
  %.4672 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.4672, align 8
  %.4705 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.4705, align 8
  store i64 %.4561, ptr %retptr, align 8
  br label %common.ret
B2870:                                            ; preds = %B2784.endif
  %.4902 = getelementptr i8, ptr %arg.control.4, i64 8
  %.4903 = load i64, ptr %.4902, align 8
  %.4932 = getelementptr i8, ptr %arg.control.4, i64 88
  store i64 %.4903, ptr %.4932, align 8
  store i64 %.745, ptr %.4902, align 8
  %.4996 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.4996, align 8
  store i64 %.13.i, ptr %retptr, align 8
  br label %common.ret
B2988:                                            ; preds = %B742
  %.79.i = sub i64 %.1034, %.979
  %.124248.not.i = icmp slt i64 %.79.i, 1
  br i1 %.124248.not.i, label %B10170, label %B38.preheader.i
B38.preheader.i:                                  ; preds = %B2988
  %12 = add nuw i64 %.79.i, 1
  br label %B38.i
B38.i:                                            ; preds = %B277.i, %B38.preheader.i
  %lsr.iv.i = phi i64 [ %12, %B38.preheader.i ], [ %lsr.iv.next.i, %B277.i ]
  %.130247249.i = phi i64 [ %.979, %B38.preheader.i ], [ %.137.i, %B277.i ]
  %.192.i = icmp slt i64 %.130247249.i, 0
  %.193.i = select i1 %.192.i, i64 %arg.moves.5.0, i64 0
  %.194.i = add i64 %.193.i, %.130247249.i
  %.214.i = mul i64 %.194.i, %arg.moves.5.1
  %13 = getelementptr i64, ptr %arg.moves.4, i64 %.214.i
  %.218.i = getelementptr i8, ptr %13, i64 16
  %.219.i = load i64, ptr %.218.i, align 8
  %.224.i = icmp slt i64 %.219.i, 0
  br i1 %.224.i, label %B82.i, label %B158.i
B82.i:                                            ; preds = %B38.i
  %sunkaddr.i = shl i64 %.214.i, 3
  %sunkaddr1.i = getelementptr i8, ptr %arg.moves.4, i64 %sunkaddr.i
  %.282.i = load i64, ptr %sunkaddr1.i, align 8
  %.296.i = icmp slt i64 %.282.i, 0
  %.297.i = select i1 %.296.i, i64 %arg.z.5.0, i64 0
  %14 = getelementptr double, ptr %arg.z.4, i64 %.282.i
  %.311.i = getelementptr double, ptr %14, i64 %.297.i
  %.312.i = load double, ptr %.311.i, align 8
  br label %B277.i
B158.i:                                           ; preds = %B38.i
  %.430.i = getelementptr double, ptr %arg.coefficients.4, i64 %.219.i
  %.431.i = load double, ptr %.430.i, align 8
  %sunkaddr2.i = shl i64 %.214.i, 3
  %sunkaddr3.i = getelementptr i8, ptr %arg.moves.4, i64 %sunkaddr2.i
  %.486.i = load i64, ptr %sunkaddr3.i, align 8
  %.500.i = icmp slt i64 %.486.i, 0
  %.501.i = select i1 %.500.i, i64 %arg.z.5.0, i64 0
  %15 = getelementptr double, ptr %arg.z.4, i64 %.486.i
  %.515.i = getelementptr double, ptr %15, i64 %.501.i
  %.516.i = load double, ptr %.515.i, align 8
  %.517.i = fmul double %.431.i, %.516.i
  %.550.i = getelementptr i8, ptr %.430.i, i64 8
  %.551.i = load double, ptr %.550.i, align 8
  %.552.i = fadd double %.517.i, %.551.i
  br label %B277.i
B277.i:                                           ; preds = %B158.i, %B82.i
  %sunkaddr4.pre-phi.i = phi i64 [ %sunkaddr2.i, %B158.i ], [ %sunkaddr.i, %B82.i ]
  %.552.sink.i = phi double [ %.552.i, %B158.i ], [ %.312.i, %B82.i ]
  %sunkaddr5.i = getelementptr i8, ptr %arg.moves.4, i64 %sunkaddr4.pre-phi.i
  %sunkaddr6.i = getelementptr i8, ptr %sunkaddr5.i, i64 8
  %.609.i = load i64, ptr %sunkaddr6.i, align 8
  %.623.i = icmp slt i64 %.609.i, 0
  %.624.i = select i1 %.623.i, i64 %arg.z.5.0, i64 0
  %16 = getelementptr double, ptr %arg.z.4, i64 %.609.i
  %.638.i = getelementptr double, ptr %16, i64 %.624.i
  store double %.552.sink.i, ptr %.638.i, align 8
  %lsr.iv.next.i = add i64 %lsr.iv.i, -1
  %.137.i = add i64 %.130247249.i, 1
  %.124.i = icmp ugt i64 %lsr.iv.next.i, 1
  br i1 %.124.i, label %B38.i, label %B10170
B3052:                                            ; preds = %B742
  %.5124 = icmp slt i64 %.1208, 0
  %.5125 = select i1 %.5124, i64 %arg.coefficients.5.0, i64 0
  %17 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.5139 = getelementptr double, ptr %17, i64 %.5125
  %.5140 = load double, ptr %.5139, align 8
  %.5155 = icmp slt i64 %.979, 0
  %.5156 = select i1 %.5155, i64 %arg.z.5.0, i64 0
  %18 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.5170 = getelementptr double, ptr %18, i64 %.5156
  %.5171 = load double, ptr %.5170, align 8
  %.5174 = fmul double %.5140, %.5171
  %.5192 = icmp slt i64 %.1208, -1
  %.5193 = select i1 %.5192, i64 %arg.coefficients.5.0, i64 0
  %19 = getelementptr i8, ptr %17, i64 8
  %.5207 = getelementptr double, ptr %19, i64 %.5193
  %.5208 = load double, ptr %.5207, align 8
  %.5209 = fadd double %.5174, %.5208
  %.5224 = icmp slt i64 %.1034, 0
  %.5225 = select i1 %.5224, i64 %arg.z.5.0, i64 0
  %20 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.5239 = getelementptr double, ptr %20, i64 %.5225
  store double %.5209, ptr %.5239, align 8
  br label %B10170
B3142:                                            ; preds = %B742
  %.5279 = icmp slt i64 %.1208, 0
  %.5280 = select i1 %.5279, i64 %arg.coefficients.5.0, i64 0
  %21 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.5294 = getelementptr double, ptr %21, i64 %.5280
  %.5295 = load double, ptr %.5294, align 8
  %.5310 = icmp slt i64 %.979, 0
  %.5311 = select i1 %.5310, i64 %arg.z.5.0, i64 0
  %22 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.5325 = getelementptr double, ptr %22, i64 %.5311
  %.5326 = load double, ptr %.5325, align 8
  %.5342 = icmp slt i64 %.1208, -2
  %.5343 = select i1 %.5342, i64 %arg.coefficients.5.0, i64 0
  %23 = getelementptr i8, ptr %21, i64 16
  %.5357 = getelementptr double, ptr %23, i64 %.5343
  %.5358 = load double, ptr %.5357, align 8
  %.5406 = icmp slt i64 %.1089, 0
  %.5407 = select i1 %.5406, i64 %arg.z.5.0, i64 0
  %24 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.5421 = getelementptr double, ptr %24, i64 %.5407
  %.5422 = load double, ptr %.5421, align 8
  %.5425 = fsub double %.5326, %.5422
  %.5426 = fmul double %.5358, %.5425
  %.5427 = fadd double %.5326, %.5426
  %.5428 = fmul double %.5295, %.5427
  %.5446 = icmp slt i64 %.1208, -1
  %.5447 = select i1 %.5446, i64 %arg.coefficients.5.0, i64 0
  %25 = getelementptr i8, ptr %21, i64 8
  %.5461 = getelementptr double, ptr %25, i64 %.5447
  %.5462 = load double, ptr %.5461, align 8
  %.5463 = fadd double %.5462, %.5428
  %.5478 = icmp slt i64 %.1034, 0
  %.5479 = select i1 %.5478, i64 %arg.z.5.0, i64 0
  %26 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.5493 = getelementptr double, ptr %26, i64 %.5479
  store double %.5463, ptr %.5493, align 8
  br label %B10170
B3292:                                            ; preds = %B742
  %.5533 = icmp slt i64 %.1034, 0
  %.5534 = select i1 %.5533, i64 %arg.z.5.0, i64 0
  %27 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.5548 = getelementptr double, ptr %27, i64 %.5534
  %.5549 = load double, ptr %.5548, align 8
  %.5564 = icmp slt i64 %.1208, 0
  %.5565 = select i1 %.5564, i64 %arg.coefficients.5.0, i64 0
  %28 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.5579 = getelementptr double, ptr %28, i64 %.5565
  %.5580 = load double, ptr %.5579, align 8
  %.5597 = icmp slt i64 %.1089, 0
  %.5598 = select i1 %.5597, i64 %arg.z.5.0, i64 0
  %29 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.5612 = getelementptr double, ptr %29, i64 %.5598
  %.5613 = load double, ptr %.5612, align 8
  %.5630 = icmp slt i64 %.979, 0
  %.5631 = select i1 %.5630, i64 %arg.z.5.0, i64 0
  %30 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.5645 = getelementptr double, ptr %30, i64 %.5631
  %.5646 = load double, ptr %.5645, align 8
  %.5649 = fadd double %.5613, %.5646
  %.5650 = fmul double %.5580, %.5649
  %.5651 = fadd double %.5549, %.5650
  store double %.5651, ptr %.5548, align 8
  br label %B10170
B3398:                                            ; preds = %B742
  %.5721 = icmp slt i64 %.1034, 0
  %.5722 = select i1 %.5721, i64 %arg.z.5.0, i64 0
  %31 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.5736 = getelementptr double, ptr %31, i64 %.5722
  %.5737 = load double, ptr %.5736, align 8
  %.5752 = icmp slt i64 %.1208, 0
  %.5753 = select i1 %.5752, i64 %arg.coefficients.5.0, i64 0
  %32 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.5767 = getelementptr double, ptr %32, i64 %.5753
  %.5768 = load double, ptr %.5767, align 8
  %.5785 = icmp slt i64 %.979, 0
  %.5786 = select i1 %.5785, i64 %arg.z.5.0, i64 0
  %33 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.5800 = getelementptr double, ptr %33, i64 %.5786
  %.5801 = load double, ptr %.5800, align 8
  %.5818 = icmp slt i64 %.1089, 0
  %.5819 = select i1 %.5818, i64 %arg.z.5.0, i64 0
  %34 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.5833 = getelementptr double, ptr %34, i64 %.5819
  %.5834 = load double, ptr %.5833, align 8
  %.5837 = fsub double %.5801, %.5834
  %.5838 = fmul double %.5768, %.5837
  %.5839 = fadd double %.5737, %.5838
  store double %.5839, ptr %.5736, align 8
  br label %B10170
B3504:                                            ; preds = %B742
  %.5908 = icmp slt i64 %.1208, -2
  %.5909 = select i1 %.5908, i64 %arg.coefficients.5.0, i64 0
  %35 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %36 = getelementptr i8, ptr %35, i64 16
  %.5923 = getelementptr double, ptr %36, i64 %.5909
  %.5924 = load double, ptr %.5923, align 8
  %.5939 = icmp slt i64 %.979, 0
  %.5940 = select i1 %.5939, i64 %arg.z.5.0, i64 0
  %37 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.5954 = getelementptr double, ptr %37, i64 %.5940
  %.5955 = load double, ptr %.5954, align 8
  %.5958 = fmul double %.5924, %.5955
  %.5974 = icmp slt i64 %.1208, -3
  %.5975 = select i1 %.5974, i64 %arg.coefficients.5.0, i64 0
  %38 = getelementptr i8, ptr %35, i64 24
  %.5989 = getelementptr double, ptr %38, i64 %.5975
  %.5990 = load double, ptr %.5989, align 8
  %.6005 = icmp slt i64 %.1089, 0
  %.6006 = select i1 %.6005, i64 %arg.z.5.0, i64 0
  %39 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.6020 = getelementptr double, ptr %39, i64 %.6006
  %.6021 = load double, ptr %.6020, align 8
  %.6024 = fmul double %.5990, %.6021
  %.6025 = fadd double %.5958, %.6024
  %.6040 = icmp slt i64 %.1208, 0
  %.6041 = select i1 %.6040, i64 %arg.coefficients.5.0, i64 0
  %.6055 = getelementptr double, ptr %35, i64 %.6041
  %.6056 = load double, ptr %.6055, align 8
  %.6071 = icmp slt i64 %.1153, 0
  %.6072 = select i1 %.6071, i64 %arg.z.5.0, i64 0
  %40 = getelementptr double, ptr %arg.z.4, i64 %.1153
  %.6086 = getelementptr double, ptr %40, i64 %.6072
  %.6087 = load double, ptr %.6086, align 8
  %.6088 = fadd double %.6087, %.6025
  %.6089 = fmul double %.6056, %.6088
  %.6107 = icmp slt i64 %.1208, -1
  %.6108 = select i1 %.6107, i64 %arg.coefficients.5.0, i64 0
  %41 = getelementptr i8, ptr %35, i64 8
  %.6122 = getelementptr double, ptr %41, i64 %.6108
  %.6123 = load double, ptr %.6122, align 8
  %.6124 = fadd double %.6123, %.6089
  %.6139 = icmp slt i64 %.1034, 0
  %.6140 = select i1 %.6139, i64 %arg.z.5.0, i64 0
  %42 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.6154 = getelementptr double, ptr %42, i64 %.6140
  store double %.6124, ptr %.6154, align 8
  %.6158 = fneg double %.6025
  store double %.6158, ptr %.6086, align 8
  br label %B10170
B3704:                                            ; preds = %B742, %B742
  %.6272 = icmp slt i64 %.979, 0
  %.6273 = select i1 %.6272, i64 %arg.z.5.0, i64 0
  %43 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.6287 = getelementptr double, ptr %43, i64 %.6273
  %.6288 = load double, ptr %.6287, align 8
  %.6305 = icmp slt i64 %.1034, 0
  %.6306 = select i1 %.6305, i64 %arg.z.5.0, i64 0
  %44 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.6320 = getelementptr double, ptr %44, i64 %.6306
  store double %.6288, ptr %.6320, align 8
  br label %B10170
B3752:                                            ; preds = %B742
  %.6337.not = icmp eq i64 %.1089, 0
  %.6393 = icmp slt i64 %.979, 0
  %.6394 = select i1 %.6393, i64 %arg.whole.5.0, i64 0
  %45 = getelementptr i64, ptr %arg.whole.4, i64 %.979
  %.6408 = getelementptr i64, ptr %45, i64 %.6394
  %.6409 = load i64, ptr %.6408, align 8
  %.6374 = uitofp i64 %.6409 to double
  %.6412 = sitofp i64 %.6409 to double
  %"$phi3874.1.2.4" = select i1 %.6337.not, double %.6412, double %.6374
  %.6443 = icmp slt i64 %.1208, 0
  %.6444 = select i1 %.6443, i64 %arg.coefficients.5.0, i64 0
  %46 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.6458 = getelementptr double, ptr %46, i64 %.6444
  %.6459 = load double, ptr %.6458, align 8
  %.6460 = fmul double %.6459, %"$phi3874.1.2.4"
  %.6478 = icmp slt i64 %.1208, -1
  %.6479 = select i1 %.6478, i64 %arg.coefficients.5.0, i64 0
  %47 = getelementptr i8, ptr %46, i64 8
  %.6493 = getelementptr double, ptr %47, i64 %.6479
  %.6494 = load double, ptr %.6493, align 8
  %.6495 = fadd double %.6494, %.6460
  %.6510 = icmp slt i64 %.1034, 0
  %.6511 = select i1 %.6510, i64 %arg.z.5.0, i64 0
  %48 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.6525 = getelementptr double, ptr %48, i64 %.6511
  store double %.6495, ptr %.6525, align 8
  br label %B10170
B3956:                                            ; preds = %B742
  %.6540.not = icmp eq i64 %.1089, 0
  br i1 %.6540.not, label %B4054, label %B3960
B3960:                                            ; preds = %B3956
  %.6556 = icmp slt i64 %.1208, 0
  %.6557 = select i1 %.6556, i64 %arg.coefficients.5.0, i64 0
  %49 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.6571 = getelementptr double, ptr %49, i64 %.6557
  %.6572 = load double, ptr %.6571, align 8
  %.6587 = icmp slt i64 %.979, 0
  %.6588 = select i1 %.6587, i64 %arg.z.5.0, i64 0
  %50 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.6602 = getelementptr double, ptr %50, i64 %.6588
  %.6603 = load double, ptr %.6602, align 8
  %.6604 = fmul double %.6572, %.6603
  %.6620 = icmp slt i64 %.1208, -1
  %.6621 = select i1 %.6620, i64 %arg.coefficients.5.0, i64 0
  %51 = getelementptr i8, ptr %49, i64 8
  %.6635 = getelementptr double, ptr %51, i64 %.6621
  %.6636 = load double, ptr %.6635, align 8
  %.6637 = fadd double %.6604, %.6636
  %.6645.le = tail call double @llvm.rint.f64(double %.6637)
  br label %B4094
B4054:                                            ; preds = %B3956
  %.6668 = icmp slt i64 %.979, 0
  %.6669 = select i1 %.6668, i64 %arg.whole.5.0, i64 0
  %52 = getelementptr i64, ptr %arg.whole.4, i64 %.979
  %.6683 = getelementptr i64, ptr %52, i64 %.6669
  %.6684 = load i64, ptr %.6683, align 8
  %.6685 = sitofp i64 %.6684 to double
  br label %B4094
B4094:                                            ; preds = %B4054, %B3960
  %"$phi4094.1.2.4" = phi double [ %.6685, %B4054 ], [ %.6645.le, %B3960 ]
  %.6710 = icmp slt i64 %.1208, -2
  %.6711 = select i1 %.6710, i64 %arg.coefficients.5.0, i64 0
  %53 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %54 = getelementptr i8, ptr %53, i64 16
  %.6725 = getelementptr double, ptr %54, i64 %.6711
  %.6726 = load double, ptr %.6725, align 8
  %.6728 = fcmp ugt double %.6726, %"$phi4094.1.2.4"
  br i1 %.6728, label %B4420, label %B4162
B4162:                                            ; preds = %B4094
  %.6754 = icmp slt i64 %.1208, -3
  %.6755 = select i1 %.6754, i64 %arg.coefficients.5.0, i64 0
  %55 = getelementptr i8, ptr %53, i64 24
  %.6769 = getelementptr double, ptr %55, i64 %.6755
  %.6770 = load double, ptr %.6769, align 8
  %.6772 = fcmp olt double %"$phi4094.1.2.4", %.6770
  br i1 %.6772, label %B4168, label %B4420
B4168:                                            ; preds = %B4162
  %56 = icmp eq i64 %.1089, 0
  %.6810 = icmp slt i64 %.979, 0
  %.6811 = select i1 %.6810, i64 %arg.whole.5.0, i64 0
  %57 = getelementptr i64, ptr %arg.whole.4, i64 %.979
  %.6825 = getelementptr i64, ptr %57, i64 %.6811
  %.6826 = load i64, ptr %.6825, align 8
  br i1 %56, label %B4250.endif, label %B4188
B4188:                                            ; preds = %B4168
  %.6840 = fcmp oge double %"$phi4094.1.2.4", 0x43E0000000000000
  %.6846 = fadd double %"$phi4094.1.2.4", 0xC3F0000000000000
  %"$phi4234.3.2.6" = select i1 %.6840, double %.6846, double %"$phi4094.1.2.4"
  %.6860 = fptosi double %"$phi4234.3.2.6" to i64
  br label %B4250.endif
B4314:                                            ; preds = %B4314.lr.ph, %B4402
  %lsr.iv1107 = phi i64 [ %.1153, %B4314.lr.ph ], [ %lsr.iv.next1108, %B4402 ]
  %lsr.iv = phi i64 [ %.7058, %B4314.lr.ph ], [ %lsr.iv.next, %B4402 ]
  %fit.3.511297 = phi i1 [ false, %B4314.lr.ph ], [ %"$phi4402.2.3.6", %B4402 ]
  br i1 %fit.3.511297, label %B4402, label %B4320
B4320:                                            ; preds = %B4314
  %58 = add i64 %lsr.iv, -1
  %.7034 = icmp slt i64 %58, 0
  %59 = select i1 %.7034, i64 %172, i64 0
  %scevgep1102 = getelementptr i8, ptr %arg.coefficients.4, i64 %59
  %60 = shl i64 %lsr.iv, 3
  %scevgep1103 = getelementptr i8, ptr %scevgep1102, i64 %60
  %scevgep1104 = getelementptr i8, ptr %scevgep1103, i64 -8
  %.7050 = load double, ptr %scevgep1104, align 8
  %.7053 = fcmp oeq double %.7050, %.7052
  br i1 %.7053, label %B4362, label %B4402
B4362:                                            ; preds = %B4320
  %.7077 = icmp slt i64 %lsr.iv, 0
  %61 = select i1 %.7077, i64 %172, i64 0
  %scevgep1105 = getelementptr i8, ptr %arg.coefficients.4, i64 %61
  %62 = shl i64 %lsr.iv, 3
  %scevgep578 = getelementptr i8, ptr %scevgep1105, i64 %62
  %.7093 = load double, ptr %scevgep578, align 8
  %.7096 = fcmp oeq double %.7093, %.7095
  br label %B4402
B4402:                                            ; preds = %B4362, %B4320, %B4314
  %"$phi4402.2.3.6" = phi i1 [ true, %B4314 ], [ %.7096, %B4362 ], [ false, %B4320 ]
  %lsr.iv.next = add i64 %lsr.iv, 2
  %lsr.iv.next1108 = add nsw i64 %lsr.iv1107, -1
  %exitcond11781.not = icmp eq i64 %lsr.iv.next1108, 0
  br i1 %exitcond11781.not, label %B4416, label %B4314
B4416:                                            ; preds = %B4402, %B4250.endif
  %fit.3.5.lcssa = phi i1 [ %.6875, %B4250.endif ], [ %"$phi4402.2.3.6", %B4402 ]
  %.7138 = icmp slt i64 %.1034, 0
  %.7139 = select i1 %.7138, i64 %arg.whole.5.0, i64 0
  %63 = getelementptr i64, ptr %arg.whole.4, i64 %.1034
  %.7153 = getelementptr i64, ptr %63, i64 %.7139
  store i64 %cell.4.5, ptr %.7153, align 8
  br i1 %fit.3.5.lcssa, label %B10170, label %B4420
B4420:                                            ; preds = %B4416, %B4162, %B4094
  %.7265 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.7265, align 8
  %.7298 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.7298, align 8
  store i64 6, ptr %retptr, align 8
  br label %common.ret
B4622:                                            ; preds = %B4622.preheader.new, %B4622
  %.76231128511287 = phi i64 [ 0, %B4622.preheader.new ], [ %.7630.1, %B4622 ]
  %64 = add i64 %.7388, %.76231128511287
  %.7670 = icmp slt i64 %64, 0
  %65 = select i1 %.7670, i64 %170, i64 0
  %scevgep1100 = getelementptr i8, ptr %scevgep, i64 %65
  %66 = shl i64 %.76231128511287, 3
  %scevgep1101 = getelementptr i8, ptr %scevgep1100, i64 %66
  %.7686 = load i64, ptr %scevgep1101, align 8
  %.7700 = icmp slt i64 %.7686, 0
  %.7701 = select i1 %.7700, i64 %arg.z.5.0, i64 0
  %67 = getelementptr double, ptr %arg.z.4, i64 %.7686
  %.7715 = getelementptr double, ptr %67, i64 %.7701
  %.7716 = load double, ptr %.7715, align 8
  %68 = add i64 %.7534, %.76231128511287
  %.7732 = icmp slt i64 %68, 0
  %69 = select i1 %.7732, i64 %171, i64 0
  %scevgep1098 = getelementptr i8, ptr %scevgep1094, i64 %69
  %70 = shl i64 %.76231128511287, 3
  %scevgep577 = getelementptr i8, ptr %scevgep1098, i64 %70
  store double %.7716, ptr %scevgep577, align 8
  %.7630.1 = add nuw i64 %.76231128511287, 2
  %71 = add i64 %.7388, %.76231128511287
  %72 = add i64 %71, 1
  %.7670.1 = icmp slt i64 %72, 0
  %73 = select i1 %.7670.1, i64 %170, i64 0
  %74 = add i64 %73, 8
  %scevgep575 = getelementptr i8, ptr %scevgep, i64 %74
  %75 = shl i64 %.76231128511287, 3
  %scevgep576 = getelementptr i8, ptr %scevgep575, i64 %75
  %.7686.1 = load i64, ptr %scevgep576, align 8
  %.7700.1 = icmp slt i64 %.7686.1, 0
  %.7701.1 = select i1 %.7700.1, i64 %arg.z.5.0, i64 0
  %76 = getelementptr double, ptr %arg.z.4, i64 %.7686.1
  %.7715.1 = getelementptr double, ptr %76, i64 %.7701.1
  %.7716.1 = load double, ptr %.7715.1, align 8
  %77 = add i64 %.7534, %.76231128511287
  %78 = add i64 %77, 1
  %.7732.1 = icmp slt i64 %78, 0
  %79 = select i1 %.7732.1, i64 %171, i64 0
  %80 = add i64 %79, 8
  %scevgep573 = getelementptr i8, ptr %scevgep1094, i64 %80
  %81 = shl i64 %.76231128511287, 3
  %scevgep574 = getelementptr i8, ptr %scevgep573, i64 %81
  store double %.7716.1, ptr %scevgep574, align 8
  %niter.ncmp.1 = icmp eq i64 %unroll_iter, %.7630.1
  br i1 %niter.ncmp.1, label %B4672.loopexit.unr-lcssa, label %B4622
B4672.loopexit.unr-lcssa:                         ; preds = %B4622
  %82 = and i64 %.7443, 1
  %lcmp.mod.not = icmp eq i64 %82, 0
  br i1 %lcmp.mod.not, label %B4672.loopexit, label %B4622.epil.preheader
B4622.epil.preheader:                             ; preds = %B4622.preheader, %B4672.loopexit.unr-lcssa
  %.76231128511287.epil.init = phi i64 [ 0, %B4622.preheader ], [ %unroll_iter, %B4672.loopexit.unr-lcssa ]
  %.7656.epil = add nsw i64 %.76231128511287.epil.init, %.7388
  %.7670.epil = icmp slt i64 %.7656.epil, 0
  %.7671.epil = select i1 %.7670.epil, i64 %arg.slots.5.0, i64 0
  %83 = getelementptr i64, ptr %arg.slots.4, i64 %.7656.epil
  %.7685.epil = getelementptr i64, ptr %83, i64 %.7671.epil
  %.7686.epil = load i64, ptr %.7685.epil, align 8
  %.7700.epil = icmp slt i64 %.7686.epil, 0
  %.7701.epil = select i1 %.7700.epil, i64 %arg.z.5.0, i64 0
  %84 = getelementptr double, ptr %arg.z.4, i64 %.7686.epil
  %.7715.epil = getelementptr double, ptr %84, i64 %.7701.epil
  %.7716.epil = load double, ptr %.7715.epil, align 8
  %.7718.epil = add nsw i64 %.76231128511287.epil.init, %.7534
  %.7732.epil = icmp slt i64 %.7718.epil, 0
  %.7733.epil = select i1 %.7732.epil, i64 %arg.buffer.5.0, i64 0
  %85 = getelementptr double, ptr %arg.buffer.4, i64 %.7718.epil
  %.7747.epil = getelementptr double, ptr %85, i64 %.7733.epil
  store double %.7716.epil, ptr %.7747.epil, align 8
  br label %B4672.loopexit
B4672.loopexit:                                   ; preds = %B4622.epil.preheader, %B4672.loopexit.unr-lcssa
  %sunkaddr1186 = shl i64 %.7517, 3
  %sunkaddr1187 = getelementptr inbounds i8, ptr %175, i64 %sunkaddr1186
  %.7798.pre = load i64, ptr %sunkaddr1187, align 8
  br label %B4672
B4672:                                            ; preds = %B4506.endif.B4672_crit_edge, %B4672.loopexit
  %sunkaddr1188.pre-phi = phi i64 [ %.pre250, %B4506.endif.B4672_crit_edge ], [ %sunkaddr1186, %B4672.loopexit ]
  %.7798 = phi i64 [ %.7532, %B4506.endif.B4672_crit_edge ], [ %.7798.pre, %B4672.loopexit ]
  %.7799 = add nsw i64 %.7798, 1
  %sunkaddr1189 = getelementptr i8, ptr %175, i64 %sunkaddr1188.pre-phi
  store i64 %.7799, ptr %sunkaddr1189, align 8
  br label %B10170
B4730:                                            ; preds = %B742
  %.7858 = icmp slt i64 %.1208, -2
  %.7859 = select i1 %.7858, i64 %arg.coefficients.5.0, i64 0
  %86 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %87 = getelementptr i8, ptr %86, i64 16
  %.7873 = getelementptr double, ptr %87, i64 %.7859
  %.7874 = load double, ptr %.7873, align 8
  %.7878 = fcmp oeq double %.7874, 0.000000e+00
  br i1 %.7878, label %B4764, label %B4802
B4764:                                            ; preds = %B4730
  %sunkaddr639 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.7909 = load i64, ptr %sunkaddr639, align 8
  %.7911 = mul nsw i64 %.7909, %arg.numerator
  %.7913 = sitofp i64 %.7911 to double
  %.7918 = fdiv double %.7913, %.9206
  br label %B4802
B4802:                                            ; preds = %B4764, %B4730
  %h.3.4 = phi double [ %.7918, %B4764 ], [ %.7874, %B4730 ]
  %.7946 = icmp slt i64 %.1034, 0
  %.7947 = select i1 %.7946, i64 %arg.z.5.0, i64 0
  %88 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.7961 = getelementptr double, ptr %88, i64 %.7947
  %.7962 = load double, ptr %.7961, align 8
  %.7977 = icmp slt i64 %.1153, 0
  %.7978 = select i1 %.7977, i64 %arg.z.5.0, i64 0
  %89 = getelementptr double, ptr %arg.z.4, i64 %.1153
  %.7992 = getelementptr double, ptr %89, i64 %.7978
  %.7993 = load double, ptr %.7992, align 8
  %.8010 = icmp slt i64 %.1208, 0
  %.8011 = select i1 %.8010, i64 %arg.coefficients.5.0, i64 0
  %.8025 = getelementptr double, ptr %86, i64 %.8011
  %.8026 = load double, ptr %.8025, align 8
  %.8041 = icmp slt i64 %.1089, 0
  %.8042 = select i1 %.8041, i64 %arg.z.5.0, i64 0
  %90 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.8056 = getelementptr double, ptr %90, i64 %.8042
  %.8057 = load double, ptr %.8056, align 8
  %.8060 = fmul double %.8026, %.8057
  %.8078 = icmp slt i64 %.1208, -1
  %.8079 = select i1 %.8078, i64 %arg.coefficients.5.0, i64 0
  %91 = getelementptr i8, ptr %86, i64 8
  %.8093 = getelementptr double, ptr %91, i64 %.8079
  %.8094 = load double, ptr %.8093, align 8
  %.8109 = icmp slt i64 %.979, 0
  %.8110 = select i1 %.8109, i64 %arg.z.5.0, i64 0
  %92 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.8124 = getelementptr double, ptr %92, i64 %.8110
  %.8125 = load double, ptr %.8124, align 8
  %.8128 = fmul double %.8094, %.8125
  %.8129 = fadd double %.8060, %.8128
  %.8130 = fmul double %.7993, %.8129
  %.8132 = fmul double %h.3.4, %.8130
  %.8135 = fadd double %.7962, %.8132
  store double %.8135, ptr %.7961, align 8
  br label %B10170
B4956:                                            ; preds = %B742
  %.8205 = icmp slt i64 %.979, 0
  %.8206 = select i1 %.8205, i64 %arg.z.5.0, i64 0
  %93 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.8220 = getelementptr double, ptr %93, i64 %.8206
  %.8221 = load double, ptr %.8220, align 8
  %.8238 = icmp slt i64 %.1089, 0
  %.8239 = select i1 %.8238, i64 %arg.z.5.0, i64 0
  %94 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.8253 = getelementptr double, ptr %94, i64 %.8239
  %.8254 = load double, ptr %.8253, align 8
  %.8257 = fsub double %.8221, %.8254
  %.8272 = icmp slt i64 %.1153, 0
  %.8273 = select i1 %.8272, i64 %arg.z.5.0, i64 0
  %95 = getelementptr double, ptr %arg.z.4, i64 %.1153
  %.8287 = getelementptr double, ptr %95, i64 %.8273
  %.8288 = load double, ptr %.8287, align 8
  %.8289 = fsub double %.8257, %.8288
  %.8304 = icmp slt i64 %.1034, 0
  %.8305 = select i1 %.8304, i64 %arg.z.5.0, i64 0
  %96 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.8319 = getelementptr double, ptr %96, i64 %.8305
  store double %.8289, ptr %.8319, align 8
  store double %.8257, ptr %.8287, align 8
  br label %B10170
B5054:                                            ; preds = %B742
  %.8390 = icmp slt i64 %.979, 0
  %.8391 = select i1 %.8390, i64 %arg.z.5.0, i64 0
  %97 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.8405 = getelementptr double, ptr %97, i64 %.8391
  %.8406 = load double, ptr %.8405, align 8
  %.8421 = icmp slt i64 %.1089, 0
  %.8422 = select i1 %.8421, i64 %arg.z.5.0, i64 0
  %98 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.8436 = getelementptr double, ptr %98, i64 %.8422
  %.8437 = load double, ptr %.8436, align 8
  %.8438 = fsub double %.8406, %.8437
  %.8503 = fmul double %.8437, 2.000000e+00
  %.8504 = fsub double %.8406, %.8503
  %.8519 = icmp slt i64 %.1153, 0
  %.8520 = select i1 %.8519, i64 %arg.z.5.0, i64 0
  %99 = getelementptr double, ptr %arg.z.4, i64 %.1153
  %.8534 = getelementptr double, ptr %99, i64 %.8520
  %.8535 = load double, ptr %.8534, align 8
  %.8538 = fadd double %.8535, %.8504
  %.8587 = icmp slt i64 %.1208, -2
  %.8588 = select i1 %.8587, i64 %arg.coefficients.5.0, i64 0
  %100 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %101 = getelementptr i8, ptr %100, i64 16
  %.8602 = getelementptr double, ptr %101, i64 %.8588
  %.8603 = load double, ptr %.8602, align 8
  %.8604 = fmul double %.8438, %.8603
  %.8605 = fadd double %.8406, %.8604
  %.8621 = icmp slt i64 %.1208, -3
  %.8622 = select i1 %.8621, i64 %arg.coefficients.5.0, i64 0
  %102 = getelementptr i8, ptr %100, i64 24
  %.8636 = getelementptr double, ptr %102, i64 %.8622
  %.8637 = load double, ptr %.8636, align 8
  %.8638 = fmul double %.8637, %.8538
  %.8639 = fadd double %.8605, %.8638
  %.8654 = icmp slt i64 %.1208, 0
  %.8655 = select i1 %.8654, i64 %arg.coefficients.5.0, i64 0
  %.8669 = getelementptr double, ptr %100, i64 %.8655
  %.8670 = load double, ptr %.8669, align 8
  %.8671 = fmul double %.8670, %.8639
  %.8689 = icmp slt i64 %.1208, -1
  %.8690 = select i1 %.8689, i64 %arg.coefficients.5.0, i64 0
  %103 = getelementptr i8, ptr %100, i64 8
  %.8704 = getelementptr double, ptr %103, i64 %.8690
  %.8705 = load double, ptr %.8704, align 8
  %.8706 = fadd double %.8705, %.8671
  %.8721 = icmp slt i64 %.1034, 0
  %.8722 = select i1 %.8721, i64 %arg.z.5.0, i64 0
  %104 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.8736 = getelementptr double, ptr %104, i64 %.8722
  store double %.8706, ptr %.8736, align 8
  br label %B10170
B5300:                                            ; preds = %B742
  %.8776 = icmp slt i64 %.1208, 0
  %.8777 = select i1 %.8776, i64 %arg.coefficients.5.0, i64 0
  %105 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.8791 = getelementptr double, ptr %105, i64 %.8777
  %.8792 = load double, ptr %.8791, align 8
  %.8807 = icmp slt i64 %.1034, 0
  %.8808 = select i1 %.8807, i64 %arg.z.5.0, i64 0
  %106 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.8822 = getelementptr double, ptr %106, i64 %.8808
  %.8823 = load double, ptr %.8822, align 8
  %.8824 = fmul double %.8792, %.8823
  %.8840 = icmp slt i64 %.1208, -1
  %.8841 = select i1 %.8840, i64 %arg.coefficients.5.0, i64 0
  %107 = getelementptr i8, ptr %105, i64 8
  %.8855 = getelementptr double, ptr %107, i64 %.8841
  %.8856 = load double, ptr %.8855, align 8
  %.8871 = icmp slt i64 %.979, 0
  %.8872 = select i1 %.8871, i64 %arg.z.5.0, i64 0
  %108 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.8886 = getelementptr double, ptr %108, i64 %.8872
  %.8887 = load double, ptr %.8886, align 8
  %.8890 = fmul double %.8856, %.8887
  %.8891 = fadd double %.8824, %.8890
  %.8907 = icmp slt i64 %.1208, -2
  %.8908 = select i1 %.8907, i64 %arg.coefficients.5.0, i64 0
  %109 = getelementptr i8, ptr %105, i64 16
  %.8922 = getelementptr double, ptr %109, i64 %.8908
  %.8923 = load double, ptr %.8922, align 8
  %.8938 = icmp slt i64 %.1089, 0
  %.8939 = select i1 %.8938, i64 %arg.z.5.0, i64 0
  %110 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.8953 = getelementptr double, ptr %110, i64 %.8939
  %.8954 = load double, ptr %.8953, align 8
  %.8957 = fmul double %.8923, %.8954
  %.8958 = fadd double %.8891, %.8957
  %.8976 = icmp slt i64 %.1208, -3
  %.8977 = select i1 %.8976, i64 %arg.coefficients.5.0, i64 0
  %111 = getelementptr i8, ptr %105, i64 24
  %.8991 = getelementptr double, ptr %111, i64 %.8977
  %.8992 = load double, ptr %.8991, align 8
  %.8993 = fadd double %.8992, %.8958
  store double %.8993, ptr %.8822, align 8
  br label %B10170
B5478:                                            ; preds = %B742
  %.9049 = add nsw i64 %.1089, %base.3.1
  %.9051 = mul nsw i64 %.9049, %arg.numerator
  %.9053 = sitofp i64 %.9051 to double
  %.9058 = fdiv double %.9053, %.9206
  %.9067 = add nsw i64 %.9049, %.1153
  %sunkaddr640 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.9099 = load i64, ptr %sunkaddr640, align 8
  %.9100 = add nsw i64 %.9067, %.9099
  %.9102 = mul nsw i64 %.9100, %arg.numerator
  %.9104 = sitofp i64 %.9102 to double
  %.9109 = fdiv double %.9104, %.9206
  store double 0.000000e+00, ptr %.9112, align 8
  %.9118 = call i32 @f73(ptr nonnull %.9112, ptr nonnull %excinfo.14, ptr %arg.coefficients.0, ptr %arg.coefficients.1, i64 %arg.coefficients.2, i64 %arg.coefficients.3, ptr %arg.coefficients.4, i64 %arg.coefficients.5.0, i64 %arg.coefficients.6.0, i64 %.1208, double %.9058, double %.9109)
  %cond547 = icmp eq i32 %.9118, 0
  br i1 %cond547, label %B5478.endif.endif.endif, label %B5478.endif.endif.if.if
B5624:                                            ; preds = %B742
  %.9197 = add nsw i64 %.1089, %base.3.1
  %.9203 = mul nsw i64 %.9197, %arg.numerator
  %.9205 = sitofp i64 %.9203 to double
  %.9210 = fdiv double %.9205, %.9206
  %.28.i = icmp slt i64 %.1208, 0
  %.29.i = select i1 %.28.i, i64 %arg.coefficients.5.0, i64 0
  %112 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.43.i = getelementptr double, ptr %112, i64 %.29.i
  %.44.i = load double, ptr %.43.i, align 8
  %.5.i.i = fptosi double %.44.i to i64
  %.88.i.i = icmp sgt i64 %.5.i.i, 1
  br i1 %.88.i.i, label %B68.else.if.preheader.i.i, label %B0.endif.common.ret_crit_edge.i
B0.endif.common.ret_crit_edge.i:                  ; preds = %B5624
  %.pre.i = add nsw i64 %.1208, 1
  br label %B5624.endif.endif
B68.else.if.preheader.i.i:                        ; preds = %B5624
  %.78.i.i = add nsw i64 %.5.i.i, -1
  %.143.i.i = add nsw i64 %.1208, 1
  br label %B68.else.if.i.i
B68.else.if.i.i:                                  ; preds = %B68.else.if.i.i, %B68.else.if.preheader.i.i
  %high.2.0.i.i = phi i64 [ %high.3.1.i.i, %B68.else.if.i.i ], [ %.78.i.i, %B68.else.if.preheader.i.i ]
  %low.2.0.i.i = phi i64 [ %low.3.1.i.i, %B68.else.if.i.i ], [ 0, %B68.else.if.preheader.i.i ]
  %.97.i.i = add nsw i64 %high.2.0.i.i, 1
  %.98.i.i = add i64 %.97.i.i, %low.2.0.i.i
  %.106.1.i.i = ashr i64 %.98.i.i, 1
  %.145.i.i = add nsw i64 %.106.1.i.i, %.143.i.i
  %.159.i.i = icmp slt i64 %.145.i.i, 0
  %.160.i.i = select i1 %.159.i.i, i64 %arg.coefficients.5.0, i64 0
  %113 = getelementptr double, ptr %arg.coefficients.4, i64 %.145.i.i
  %.174.i.i = getelementptr double, ptr %113, i64 %.160.i.i
  %.175.i.i = load double, ptr %.174.i.i, align 8
  %.177.i.i = fcmp ole double %.175.i.i, %.9210
  %.202.i.i = add nsw i64 %.106.1.i.i, -1
  %high.3.1.i.i = select i1 %.177.i.i, i64 %high.2.0.i.i, i64 %.202.i.i
  %low.3.1.i.i = select i1 %.177.i.i, i64 %.106.1.i.i, i64 %low.2.0.i.i
  %.219.i.i = icmp slt i64 %low.3.1.i.i, %high.3.1.i.i
  br i1 %.219.i.i, label %B68.else.if.i.i, label %B5624.endif.endif
B5686:                                            ; preds = %B742
  %114 = and i64 %.805, -2
  %or.cond.i454.not = icmp eq i64 %114, 14
  br i1 %or.cond.i454.not, label %B5718, label %B6384
B5718:                                            ; preds = %B5686
  %.9319 = icmp slt i64 %.915, 0
  br i1 %.9319, label %B5730.endif, label %B5872
B5762:                                            ; preds = %B5762.preheader569, %B5762
  %.94211130211304 = phi i64 [ %.9428.3, %B5762 ], [ %.94211130211304.unr, %B5762.preheader569 ]
  %sunkaddr641 = mul i64 %.94211130211304, 8
  %sunkaddr642 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr641
  %.9554 = load double, ptr %sunkaddr642, align 8
  %sunkaddr643 = mul i64 %.94211130211304, 8
  %sunkaddr644 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr643
  store double %.9554, ptr %sunkaddr644, align 8
  %sunkaddr645 = mul i64 %.94211130211304, 8
  %sunkaddr646 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr645
  %sunkaddr647 = getelementptr i8, ptr %sunkaddr646, i64 8
  %.9554.1 = load double, ptr %sunkaddr647, align 8
  %sunkaddr648 = mul i64 %.94211130211304, 8
  %sunkaddr649 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr648
  %sunkaddr650 = getelementptr i8, ptr %sunkaddr649, i64 8
  store double %.9554.1, ptr %sunkaddr650, align 8
  %sunkaddr651 = mul i64 %.94211130211304, 8
  %sunkaddr652 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr651
  %sunkaddr653 = getelementptr i8, ptr %sunkaddr652, i64 16
  %.9554.2 = load double, ptr %sunkaddr653, align 8
  %sunkaddr654 = mul i64 %.94211130211304, 8
  %sunkaddr655 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr654
  %sunkaddr656 = getelementptr i8, ptr %sunkaddr655, i64 16
  store double %.9554.2, ptr %sunkaddr656, align 8
  %.9428.3 = add nuw nsw i64 %.94211130211304, 4
  %sunkaddr657 = mul i64 %.94211130211304, 8
  %sunkaddr658 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr657
  %sunkaddr659 = getelementptr i8, ptr %sunkaddr658, i64 24
  %.9554.3 = load double, ptr %sunkaddr659, align 8
  %sunkaddr660 = mul i64 %.94211130211304, 8
  %sunkaddr661 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr660
  %sunkaddr662 = getelementptr i8, ptr %sunkaddr661, i64 24
  store double %.9554.3, ptr %sunkaddr662, align 8
  %exitcond11782.not.3 = icmp eq i64 %.979, %.9428.3
  br i1 %exitcond11782.not.3, label %B10170, label %B5762
B5872:                                            ; preds = %B5718
  %115 = ptrtoint ptr %arg.states.4 to i64
  %116 = icmp eq i64 %.805, 15
  %.9686 = shl i64 %.915, 3
  %.9687 = add nsw i64 %.9686, %115
  br i1 %116, label %B5934.endif, label %B6034
B6034:                                            ; preds = %B5872
  %117 = getelementptr i64, ptr %arg.states.4, i64 %.915
  %.9911 = load i64, ptr %117, align 8
  %.9912.not = icmp eq i64 %.9911, 0
  %.pre = mul i64 %.915, %arg.state_calls.5.1
  br i1 %.9912.not, label %B6034.B6184.endif_crit_edge, label %B6154
B6034.B6184.endif_crit_edge:                      ; preds = %B6034
  %.pre723 = mul i64 %.915, %arg.components.5.1
  %.pre724 = inttoptr i64 %.9687 to ptr
  br label %B6184.endif
B6154:                                            ; preds = %B6034
  %118 = getelementptr i64, ptr %arg.state_calls.4, i64 %.pre
  %.9967 = getelementptr i8, ptr %118, i64 16
  %.9968 = load i64, ptr %.9967, align 8
  %.10018 = mul i64 %.915, %arg.components.5.1
  %119 = getelementptr i64, ptr %arg.components.4, i64 %.10018
  %.10022 = getelementptr i8, ptr %119, i64 8
  %.10023 = load i64, ptr %.10022, align 8
  %.7.i461 = inttoptr i64 %.9968 to ptr
  %.8.i462 = inttoptr i64 %.10023 to ptr
  %.9.i463 = inttoptr i64 %.9687 to ptr
  %.10.i464 = tail call i32 %.7.i461(ptr %.8.i462, ptr %.9.i463)
  %sunkaddr663 = mul i64 %.915, 8
  %sunkaddr664 = getelementptr i8, ptr %arg.states.4, i64 %sunkaddr663
  store i64 0, ptr %sunkaddr664, align 8
  %.6.i465 = icmp ugt i32 %.10.i464, 1
  br i1 %.6.i465, label %B6300, label %B6184.endif
B6270:                                            ; preds = %B6184.endif, %B5934.endif
  %status.10.4.in = phi i32 [ %.10.i, %B5934.endif ], [ %.10.i470, %B6184.endif ]
  %.6.i471 = icmp ugt i32 %status.10.4.in, 1
  br i1 %.6.i471, label %B6300, label %B10170
B6300:                                            ; preds = %B6270, %B6154
  %status.10.4.in729 = phi i32 [ %status.10.4.in, %B6270 ], [ %.10.i464, %B6154 ]
  %status.10.4 = sext i32 %status.10.4.in729 to i64
  %.10395 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.10395, align 8
  %.10428 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.10428, align 8
  %.10461 = getelementptr i8, ptr %arg.control.4, i64 24
  store i64 %status.10.4, ptr %.10461, align 8
  store i64 2, ptr %retptr, align 8
  br label %common.ret
B6384:                                            ; preds = %B5686
  switch i64 %.805, label %B8654 [
    i64 16, label %B6406
    i64 17, label %B6464
    i64 26, label %B6650.else
    i64 18, label %B6858
    i64 19, label %B6894
    i64 20, label %B7000
    i64 23, label %B7156.else.if
    i64 24, label %B7224
    i64 25, label %B7386
    i64 29, label %B7826
    i64 30, label %B8538
  ]
B6406:                                            ; preds = %B6384
  %.10521 = icmp slt i64 %.979, 0
  %.10522 = select i1 %.10521, i64 %arg.rows.5.0, i64 0
  %120 = getelementptr i64, ptr %arg.rows.4, i64 %.979
  %.10536 = getelementptr i64, ptr %120, i64 %.10522
  %.10537 = load i64, ptr %.10536, align 8
  %.10539 = sub nsw i64 %.10537, %.1034
  store i64 %.10539, ptr %.10536, align 8
  br label %B10170
B6464:                                            ; preds = %B6384
  store i64 0, ptr %.10592, align 8
  %.10602 = call i32 @f74(ptr nonnull %.10592, ptr nonnull %excinfo.23, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %.1034, i64 %.1089, i64 %.1153, ptr %arg.coefficients.0, ptr %arg.coefficients.1, i64 %arg.coefficients.2, i64 %arg.coefficients.3, ptr %arg.coefficients.4, i64 %arg.coefficients.5.0, i64 %arg.coefficients.6.0, i64 %.1208, ptr %arg.work.0, ptr %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0)
  %cond542 = icmp eq i32 %.10602, 0
  br i1 %cond542, label %B6464.endif, label %B6464.if.if
B6528:                                            ; preds = %B6464.endif
  %.10646 = add nsw i64 %.979, -1
  br label %B10170
B6564:                                            ; preds = %B6464.endif
  %.10748 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.10748, align 8
  %.10781 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.10781, align 8
  store i64 4, ptr %retptr, align 8
  br label %common.ret
B6730:                                            ; preds = %B6650.endif.endif
  %.11040 = sub i64 %m.6.1, %.979
  br label %B10170
B6772:                                            ; preds = %B6650.endif.endif
  %.11142 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.11142, align 8
  %.11175 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.11175, align 8
  store i64 4, ptr %retptr, align 8
  br label %common.ret
B6858:                                            ; preds = %B6384
  %.11219 = add nsw i64 %.979, -1
  br label %B10170
B6894:                                            ; preds = %B6384
  %sunkaddr665 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.11273 = load i64, ptr %sunkaddr665, align 8
  %.11275 = mul nsw i64 %.11273, %arg.numerator
  %.11277 = sitofp i64 %.11275 to double
  %.11282 = fdiv double %.11277, %.9206
  %.49.i = icmp slt i64 %.1034, 0
  %.50.i = select i1 %.49.i, i64 %arg.z.5.0, i64 0
  %121 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.64.i = getelementptr double, ptr %121, i64 %.50.i
  %.65.i = load double, ptr %.64.i, align 8
  %.78.i473 = icmp slt i64 %.1089, 0
  %.79.i474 = select i1 %.78.i473, i64 %arg.z.5.0, i64 0
  %122 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.93.i = getelementptr double, ptr %122, i64 %.79.i474
  %.94.i = load double, ptr %.93.i, align 8
  %.95.i = fmul double %.65.i, %.94.i
  %.96.i = fmul double %.11282, %.95.i
  %.109.i = icmp slt i64 %.1153, 0
  %.110.i = select i1 %.109.i, i64 %arg.z.5.0, i64 0
  %123 = getelementptr double, ptr %arg.z.4, i64 %.1153
  %.124.i475 = getelementptr double, ptr %123, i64 %.110.i
  %.125.i = load double, ptr %.124.i475, align 8
  %.138.i = icmp slt i64 %.979, 0
  %.139.i = select i1 %.138.i, i64 %arg.z.5.0, i64 0
  %124 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.153.i = getelementptr double, ptr %124, i64 %.139.i
  %.154.i = load double, ptr %.153.i, align 8
  %.155.i = fmul double %.125.i, %.154.i
  %.156.i = fmul double %.11282, %.155.i
  %.157.i = tail call double @llvm.fabs.f64(double %.96.i)
  %.158.i = tail call double @llvm.fabs.f64(double %.156.i)
  %.10.i.i476 = fcmp ogt double %.158.i, %.157.i
  %.11.i.i477 = select i1 %.10.i.i476, double %.158.i, double %.157.i
  %.189.i = fsub double %.96.i, %.156.i
  %.202.i = icmp slt i64 %.1208, 0
  %.203.i = select i1 %.202.i, i64 %arg.coefficients.5.0, i64 0
  %125 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.217.i = getelementptr double, ptr %125, i64 %.203.i
  %.218.i478 = load double, ptr %.217.i, align 8
  %.232.i = icmp slt i64 %.1208, -1
  %.233.i = select i1 %.232.i, i64 %arg.coefficients.5.0, i64 0
  %126 = getelementptr i8, ptr %125, i64 8
  %.247.i = getelementptr double, ptr %126, i64 %.233.i
  %.248.i = load double, ptr %.247.i, align 8
  %.249.i = fmul double %.248.i, %.11.i.i477
  %.250.i = fadd double %.218.i478, %.249.i
  %.254.i = fdiv double %.189.i, %.250.i
  %.283.i = load double, ptr %arg.work.4, align 8
  %.284.i = fmul double %.254.i, %.254.i
  %.285.i = fadd double %.283.i, %.284.i
  store double %.285.i, ptr %arg.work.4, align 8
  %sunkaddr666 = getelementptr i8, ptr %arg.work.4, i64 8
  %.343.i = load double, ptr %sunkaddr666, align 8
  %.344.i = fadd double %.343.i, 1.000000e+00
  store double %.344.i, ptr %sunkaddr666, align 8
  br label %B10170
B7000:                                            ; preds = %B6384
  %sunkaddr667 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.11386 = load i64, ptr %sunkaddr667, align 8
  %.11388 = mul nsw i64 %.11386, %arg.numerator
  %.11390 = sitofp i64 %.11388 to double
  %.11395 = fdiv double %.11390, %.9206
  %.11411 = icmp slt i64 %.979, -1
  %.11412 = select i1 %.11411, i64 %arg.z.5.0, i64 0
  %127 = getelementptr double, ptr %arg.z.4, i64 %.979
  %128 = getelementptr i8, ptr %127, i64 8
  %.11426 = getelementptr double, ptr %128, i64 %.11412
  store double %.11395, ptr %.11426, align 8
  %.11442 = call i32 @f75(ptr nonnull %.11432, ptr nonnull %excinfo.26, ptr %arg.clock.0, ptr %arg.clock.1, i64 %arg.clock.2, i64 %arg.clock.3, ptr nonnull %arg.clock.4, i64 %arg.clock.5.0, i64 %arg.clock.6.0, ptr %arg.coefficients.0, ptr %arg.coefficients.1, i64 %arg.coefficients.2, i64 %arg.coefficients.3, ptr %arg.coefficients.4, i64 %arg.coefficients.5.0, i64 %arg.coefficients.6.0, i64 %.1208, ptr %arg.work.0, ptr %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0)
  %cond544 = icmp eq i32 %.11442, 0
  br i1 %cond544, label %B7000.endif.endif, label %B7000.endif.if.if
B7224:                                            ; preds = %B6384
  %sunkaddr668 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.11746 = load i64, ptr %sunkaddr668, align 8
  %sunkaddr669 = getelementptr i8, ptr %arg.clock.4, i64 48
  store i64 %.11746, ptr %sunkaddr669, align 8
  %sunkaddr670 = getelementptr i8, ptr %arg.control.4, i64 64
  %.11806 = load i64, ptr %sunkaddr670, align 8
  %.11840 = load i64, ptr %arg.clock.4, align 8
  %.11810 = add i64 %.11746, %.641
  %.11841 = add i64 %.11810, %.11806
  %.11872 = add i64 %.11841, %.11840
  br label %B10170
B7386:                                            ; preds = %B6384
  %sunkaddr671 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.11914 = load i64, ptr %sunkaddr671, align 8
  %.11917 = mul i64 %.11915, %.11914
  %.11919 = sitofp i64 %.11917 to double
  %.11924 = fdiv double %.11919, %.9206
  %.11940 = icmp slt i64 %.1034, -1
  %.11941 = select i1 %.11940, i64 %arg.z.5.0, i64 0
  %129 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %130 = getelementptr i8, ptr %129, i64 8
  %.11955 = getelementptr double, ptr %130, i64 %.11941
  store double %.11924, ptr %.11955, align 8
  store i64 0, ptr %.11964, align 8
  %.11976 = call i32 @f76(ptr nonnull %.11964, ptr nonnull %excinfo.27, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %.1089, i64 %.1153, ptr %arg.clock.0, ptr %arg.clock.1, i64 %arg.clock.2, i64 %arg.clock.3, ptr nonnull %arg.clock.4, i64 %arg.clock.5.0, i64 %arg.clock.6.0, ptr %arg.coefficients.0, ptr %arg.coefficients.1, i64 %arg.coefficients.2, i64 %arg.coefficients.3, ptr %arg.coefficients.4, i64 %arg.coefficients.5.0, i64 %arg.coefficients.6.0, i64 %.1208, ptr %arg.work.0, ptr %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0)
  %cond545 = icmp eq i32 %.11976, 0
  br i1 %cond545, label %B7386.endif.endif, label %B7386.endif.if.if
B7506:                                            ; preds = %B7386.endif.endif
  %.12046 = load i64, ptr %arg.clock.4, align 8
  %.12076 = load double, ptr %arg.work.4, align 8
  %sunkaddr672 = getelementptr i8, ptr %arg.work.4, i64 16
  %.12106 = load double, ptr %sunkaddr672, align 8
  %.12121 = icmp slt i64 %.1034, 0
  %.12122 = select i1 %.12121, i64 %arg.z.5.0, i64 0
  %.12136 = getelementptr double, ptr %129, i64 %.12122
  %.12137 = sitofp i64 %.12046 to double
  store double %.12137, ptr %.12136, align 8
  %.12154 = icmp slt i64 %.1034, -2
  %.12155 = select i1 %.12154, i64 %arg.z.5.0, i64 0
  %131 = getelementptr i8, ptr %129, i64 16
  %.12169 = getelementptr double, ptr %131, i64 %.12155
  store double %.12076, ptr %.12169, align 8
  %.12188 = icmp slt i64 %.1034, -3
  %.12189 = select i1 %.12188, i64 %arg.z.5.0, i64 0
  %132 = getelementptr i8, ptr %129, i64 24
  %.12203 = getelementptr double, ptr %132, i64 %.12189
  store double %.12106, ptr %.12203, align 8
  store double 0.000000e+00, ptr %sunkaddr672, align 8
  %.12236 = add nsw i64 %.979, -1
  br label %B10170
B7672:                                            ; preds = %B7386.endif.endif
  %sunkaddr673 = getelementptr i8, ptr %arg.control.4, i64 64
  %.12287 = load i64, ptr %sunkaddr673, align 8
  %.12291 = add nsw i64 %.12287, %.641
  %.12321 = load i64, ptr %arg.clock.4, align 8
  %.12322 = add nsw i64 %.12291, %.12321
  br label %B10170
B7742:                                            ; preds = %B7386.endif.endif
  %.12413 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.12413, align 8
  %.12446 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.12446, align 8
  store i64 4, ptr %retptr, align 8
  br label %common.ret
B7826:                                            ; preds = %B6384
  %sunkaddr674 = getelementptr i8, ptr %arg.control.4, i64 80
  %.12496 = load i64, ptr %sunkaddr674, align 8
  %.12501 = add i64 %.915, 1
  %.12503 = add i64 %.12501, %.12496
  %.12509 = add nsw i64 %.1034, %base.3.1
  %.12511 = mul nsw i64 %.12509, %arg.numerator
  %.12513 = sitofp i64 %.12511 to double
  %.12518 = fdiv double %.12513, %.9206
  %.12525 = add nsw i64 %.12509, %.979
  %.12527 = mul nsw i64 %.12525, %arg.numerator
  %.12529 = sitofp i64 %.12527 to double
  %.12534 = fdiv double %.12529, %.9206
  %.12543 = mul nsw i64 %.979, %arg.numerator
  %.12547 = sitofp i64 %.12543 to double
  %.12552 = fdiv double %.12547, %.9206
  %.12571 = icmp slt i64 %.12496, 0
  %.12572 = select i1 %.12571, i64 %arg.solver.5.0, i64 0
  %133 = getelementptr double, ptr %arg.solver.4, i64 %.12496
  %.12586 = getelementptr double, ptr %133, i64 %.12572
  %.12587 = load double, ptr %.12586, align 8
  %.12588 = fcmp ogt double %.12534, %.12587
  br i1 %.12588, label %B7984, label %B8048
B7984:                                            ; preds = %B7826
  %.12.i479 = fsub double %.12587, %.12518
  %.20.i480 = fadd double %.12518, %.12.i479
  %.22.i481 = fcmp ogt double %.20.i480, %.12587
  br i1 %.22.i481, label %B32.i483.preheader, label %B8048
B32.i483.preheader:                               ; preds = %B7984
  br label %B32.i483
B32.i483:                                         ; preds = %B32.i483.preheader, %B32.i483
  %length.2.0.i484 = phi double [ %.25.i485, %B32.i483 ], [ %.12.i479, %B32.i483.preheader ]
  %.25.i485 = fmul double %length.2.0.i484, 0x3FEFFFFFFFFFFFFE
  %.31.i486 = fadd double %.12518, %.25.i485
  %.33.i487 = fcmp ogt double %.31.i486, %.12587
  br i1 %.33.i487, label %B32.i483, label %B8048
B8048:                                            ; preds = %B32.i483, %B7984, %B7826
  %end.3.4 = phi double [ %.12534, %B7826 ], [ %.12587, %B7984 ], [ %.12587, %B32.i483 ]
  %length.8.4 = phi double [ %.12552, %B7826 ], [ %.12.i479, %B7984 ], [ %.25.i485, %B32.i483 ]
  %.12680 = icmp slt i64 %.12503, 0
  %.12681 = select i1 %.12680, i64 %arg.solver.5.0, i64 0
  %134 = getelementptr double, ptr %arg.solver.4, i64 %.12503
  %.12695 = getelementptr double, ptr %134, i64 %.12681
  %.12696 = load double, ptr %.12695, align 8
  %.12698 = fcmp ogt double %.12696, %.12518
  br i1 %.12698, label %B8072, label %B8048.B8120_crit_edge
B8048.B8120_crit_edge:                            ; preds = %B8048
  %.pre725 = fadd double %.12518, %length.8.4
  br label %B8120
B8072:                                            ; preds = %B8048
  %.12.i489 = fsub double %end.3.4, %.12696
  %.20.i490 = fadd double %.12696, %.12.i489
  %.22.i491 = fcmp ogt double %.20.i490, %end.3.4
  br i1 %.22.i491, label %B32.i493.preheader, label %B8120
B32.i493.preheader:                               ; preds = %B8072
  br label %B32.i493
B32.i493:                                         ; preds = %B32.i493.preheader, %B32.i493
  %length.2.0.i494 = phi double [ %.25.i495, %B32.i493 ], [ %.12.i489, %B32.i493.preheader ]
  %.25.i495 = fmul double %length.2.0.i494, 0x3FEFFFFFFFFFFFFE
  %.31.i496 = fadd double %.12696, %.25.i495
  %.33.i497 = fcmp ogt double %.31.i496, %end.3.4
  br i1 %.33.i497, label %B32.i493, label %B8120
B8120:                                            ; preds = %B32.i493, %B8072, %B8048.B8120_crit_edge
  %.12769.pre-phi = phi double [ %.pre725, %B8048.B8120_crit_edge ], [ %.20.i490, %B8072 ], [ %.31.i496, %B32.i493 ]
  %time.4.4 = phi double [ %.12518, %B8048.B8120_crit_edge ], [ %.12696, %B8072 ], [ %.12696, %B32.i493 ]
  %length.7.4 = phi double [ %length.8.4, %B8048.B8120_crit_edge ], [ %.12.i489, %B8072 ], [ %.25.i495, %B32.i493 ]
  %.12773 = fcmp ogt double %.12769.pre-phi, %"$phi116.0.2.0"
  br i1 %.12773, label %B8138, label %B8170
B8138:                                            ; preds = %B8120
  %.12.i499 = fsub double %"$phi116.0.2.0", %time.4.4
  %.20.i500 = fadd double %time.4.4, %.12.i499
  %.22.i501 = fcmp ogt double %.20.i500, %"$phi116.0.2.0"
  br i1 %.22.i501, label %B32.i503.preheader, label %B8170
B32.i503.preheader:                               ; preds = %B8138
  br label %B32.i503
B32.i503:                                         ; preds = %B32.i503.preheader, %B32.i503
  %length.2.0.i504 = phi double [ %.25.i505, %B32.i503 ], [ %.12.i499, %B32.i503.preheader ]
  %.25.i505 = fmul double %length.2.0.i504, 0x3FEFFFFFFFFFFFFE
  %.31.i506 = fadd double %time.4.4, %.25.i505
  %.33.i507 = fcmp ogt double %.31.i506, %"$phi116.0.2.0"
  br i1 %.33.i507, label %B32.i503, label %B8170
B8170:                                            ; preds = %B32.i503, %B8138, %B8120
  %length.9.4 = phi double [ %length.7.4, %B8120 ], [ %.12.i499, %B8138 ], [ %.25.i505, %B32.i503 ]
  %.12818 = add nsw i64 %.12503, %arg.components.5.0
  %.12833 = icmp slt i64 %.12818, 0
  %.12834 = select i1 %.12833, i64 %arg.solver.5.0, i64 0
  %135 = getelementptr double, ptr %arg.solver.4, i64 %.12818
  %.12848 = getelementptr double, ptr %135, i64 %.12834
  store double %time.4.4, ptr %.12848, align 8
  %.12852 = fcmp olt double %time.4.4, %end.3.4
  br i1 %.12852, label %B8220, label %B10170
B8220:                                            ; preds = %B8170
  %.12881 = icmp slt i64 %.915, 0
  %.12882 = select i1 %.12881, i64 %arg.components.5.0, i64 0
  %.12883 = add i64 %.12882, %.915
  %.12903 = mul i64 %.12883, %arg.components.5.1
  %.12907 = getelementptr i64, ptr %arg.components.4, i64 %.12903
  %.12908 = load i64, ptr %.12907, align 8
  %.12962 = getelementptr i8, ptr %.12907, i64 16
  %.12963 = load i64, ptr %.12962, align 8
  %.13017 = getelementptr i8, ptr %.12907, i64 8
  %.13018 = load i64, ptr %.13017, align 8
  %.13072 = getelementptr i8, ptr %.12907, i64 64
  %.13073 = load i64, ptr %.13072, align 8
  %.13129 = getelementptr i8, ptr %.12907, i64 24
  %.13130 = load i64, ptr %.13129, align 8
  %.13137 = call i32 @f77(ptr nonnull %.13133, ptr nonnull %excinfo.31, i64 %.12908, i64 %.12963, i64 %.13018, double %time.4.4, double %length.9.4, i64 %.13073, i64 %.13130)
  %cond546 = icmp eq i32 %.13137, 0
  br i1 %cond546, label %B8220.endif, label %B8220.if.if
B8422:                                            ; preds = %B8220.endif
  %.13292 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.13292, align 8
  %.13325 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.13325, align 8
  %.13358 = getelementptr i8, ptr %arg.control.4, i64 24
  store i64 %.13147, ptr %.13358, align 8
  store i64 2, ptr %retptr, align 8
  br label %common.ret
B8502:                                            ; preds = %B8220.endif
  %sunkaddr1226 = shl i64 %.12681, 3
  %sunkaddr1227 = getelementptr inbounds i8, ptr %134, i64 %sunkaddr1226
  store double %end.3.4, ptr %sunkaddr1227, align 8
  br label %B10170
B8538:                                            ; preds = %B6384
  %.13442.not = icmp eq i64 %.979, 0
  br i1 %.13442.not, label %B8550, label %B8590
B8550:                                            ; preds = %B8538
  %.13448 = add nsw i64 %.860, %base.3.1
  %sunkaddr675 = getelementptr i8, ptr %arg.control.4, i64 72
  %.13480 = load i64, ptr %sunkaddr675, align 8
  %.13481.not = icmp slt i64 %.13448, %.13480
  br i1 %.13481.not, label %B10170, label %B8590
B8590:                                            ; preds = %B8550, %B8538
  %.13574 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.13574, align 8
  %.13607 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.13607, align 8
  store i64 7, ptr %retptr, align 8
  br label %common.ret
B8654:                                            ; preds = %B6384
  %136 = add i64 %.805, -33
  %or.cond.i511 = icmp ult i64 %136, -2
  br i1 %or.cond.i511, label %B9040, label %B8686
B8686:                                            ; preds = %B8654
  %.84.i509 = icmp eq i64 %.805, 31
  %sunkaddr676 = getelementptr i8, ptr %arg.control.4, i64 80
  %.13700 = load i64, ptr %sunkaddr676, align 8
  %.13701 = add i64 %.915, 1
  %.13703 = add i64 %.13701, %.13700
  %.13719 = icmp slt i64 %.13703, 0
  %.13720 = select i1 %.13719, i64 %arg.solver.5.0, i64 0
  %137 = getelementptr double, ptr %arg.solver.4, i64 %.13703
  %.13734 = getelementptr double, ptr %137, i64 %.13720
  %.13735 = load double, ptr %.13734, align 8
  %.13749 = add nsw i64 %.13703, %arg.components.5.0
  %.13763 = icmp slt i64 %.13749, 0
  %.13764 = select i1 %.13763, i64 %arg.solver.5.0, i64 0
  %138 = getelementptr double, ptr %arg.solver.4, i64 %.13749
  %.13778 = getelementptr double, ptr %138, i64 %.13764
  %.13779 = load double, ptr %.13778, align 8
  %.13780 = fsub double %.13735, %.13779
  %.13815 = icmp slt i64 %.1034, 0
  %.13816 = select i1 %.13815, i64 %arg.z.5.0, i64 0
  %139 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.13830 = getelementptr double, ptr %139, i64 %.13816
  %.13831 = load double, ptr %.13830, align 8
  br i1 %.84.i509, label %B8818, label %B8908
B8818:                                            ; preds = %B8686
  %.13846 = icmp slt i64 %.1208, 0
  %.13847 = select i1 %.13846, i64 %arg.coefficients.5.0, i64 0
  %140 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.13861 = getelementptr double, ptr %140, i64 %.13847
  %.13862 = load double, ptr %.13861, align 8
  %.13866 = fmul double %.13780, %.13862
  %.13883 = icmp slt i64 %.1089, 0
  %.13884 = select i1 %.13883, i64 %arg.z.5.0, i64 0
  %141 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.13898 = getelementptr double, ptr %141, i64 %.13884
  %.13899 = load double, ptr %.13898, align 8
  %.13916 = icmp slt i64 %.979, 0
  %.13917 = select i1 %.13916, i64 %arg.z.5.0, i64 0
  %142 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.13931 = getelementptr double, ptr %142, i64 %.13917
  %.13932 = load double, ptr %.13931, align 8
  %.13935 = fadd double %.13899, %.13932
  %.13936 = fmul double %.13866, %.13935
  %.13937 = fadd double %.13831, %.13936
  %sunkaddr1230 = shl i64 %.13816, 3
  %sunkaddr1231 = getelementptr inbounds i8, ptr %139, i64 %sunkaddr1230
  store double %.13937, ptr %sunkaddr1231, align 8
  br label %B10170
B8908:                                            ; preds = %B8686
  %.14027 = icmp slt i64 %.1153, 0
  %.14028 = select i1 %.14027, i64 %arg.z.5.0, i64 0
  %143 = getelementptr double, ptr %arg.z.4, i64 %.1153
  %.14042 = getelementptr double, ptr %143, i64 %.14028
  %.14043 = load double, ptr %.14042, align 8
  %.14060 = icmp slt i64 %.1208, 0
  %.14061 = select i1 %.14060, i64 %arg.coefficients.5.0, i64 0
  %144 = getelementptr double, ptr %arg.coefficients.4, i64 %.1208
  %.14075 = getelementptr double, ptr %144, i64 %.14061
  %.14076 = load double, ptr %.14075, align 8
  %.14091 = icmp slt i64 %.1089, 0
  %.14092 = select i1 %.14091, i64 %arg.z.5.0, i64 0
  %145 = getelementptr double, ptr %arg.z.4, i64 %.1089
  %.14106 = getelementptr double, ptr %145, i64 %.14092
  %.14107 = load double, ptr %.14106, align 8
  %.14110 = fmul double %.14076, %.14107
  %.14128 = icmp slt i64 %.1208, -1
  %.14129 = select i1 %.14128, i64 %arg.coefficients.5.0, i64 0
  %146 = getelementptr i8, ptr %144, i64 8
  %.14143 = getelementptr double, ptr %146, i64 %.14129
  %.14144 = load double, ptr %.14143, align 8
  %.14159 = icmp slt i64 %.979, 0
  %.14160 = select i1 %.14159, i64 %arg.z.5.0, i64 0
  %147 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.14174 = getelementptr double, ptr %147, i64 %.14160
  %.14175 = load double, ptr %.14174, align 8
  %.14178 = fmul double %.14144, %.14175
  %.14179 = fadd double %.14110, %.14178
  %.14180 = fmul double %.14043, %.14179
  %.14182 = fmul double %.13780, %.14180
  %.14185 = fadd double %.13831, %.14182
  %sunkaddr1232 = shl i64 %.13816, 3
  %sunkaddr1233 = getelementptr i8, ptr %139, i64 %sunkaddr1232
  store double %.14185, ptr %sunkaddr1233, align 8
  br label %B10170
B9040:                                            ; preds = %B8654
  switch i64 %.805, label %B10170 [
    i64 34, label %B9062
    i64 33, label %B9572
    i64 36, label %B9946
  ]
B9062:                                            ; preds = %B9040
  %.14244 = icmp slt i64 %.979, 0
  %.14245 = select i1 %.14244, i64 %arg.z.5.0, i64 0
  %148 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.14259 = getelementptr double, ptr %148, i64 %.14245
  %.14260 = load double, ptr %.14259, align 8
  %.14262 = fcmp oeq double %.14260, 2.000000e+00
  br i1 %.14262, label %B9112, label %B9154
B9112:                                            ; preds = %B9062
  %.14295 = icmp slt i64 %.979, -2
  %.14296 = select i1 %.14295, i64 %arg.whole.5.0, i64 0
  %149 = getelementptr i64, ptr %arg.whole.4, i64 %.979
  %150 = getelementptr i8, ptr %149, i64 16
  %.14310 = getelementptr i64, ptr %150, i64 %.14296
  %.14311 = load i64, ptr %.14310, align 8
  %.14326 = icmp slt i64 %.1034, 0
  %.14327 = select i1 %.14326, i64 %arg.whole.5.0, i64 0
  %151 = getelementptr i64, ptr %arg.whole.4, i64 %.1034
  %.14341 = getelementptr i64, ptr %151, i64 %.14327
  store i64 %.14311, ptr %.14341, align 8
  br label %B10170
B9154:                                            ; preds = %B9062
  %.14379 = fcmp oeq double %.14260, 1.000000e+00
  br i1 %.14379, label %B9204, label %B10170
B9204:                                            ; preds = %B9154
  %.14396 = icmp slt i64 %.979, -1
  %.14397 = select i1 %.14396, i64 %arg.z.5.0, i64 0
  %152 = getelementptr i8, ptr %148, i64 8
  %.14411 = getelementptr double, ptr %152, i64 %.14397
  %.14412 = load double, ptr %.14411, align 8
  %.14427 = icmp slt i64 %.1034, 0
  %.14428 = select i1 %.14427, i64 %arg.z.5.0, i64 0
  %153 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.14442 = getelementptr double, ptr %153, i64 %.14428
  %.14443 = load double, ptr %.14442, align 8
  %.14444 = fmul double %.14412, %.14443
  %.14460 = icmp slt i64 %.979, -2
  %.14461 = select i1 %.14460, i64 %arg.z.5.0, i64 0
  %154 = getelementptr i8, ptr %148, i64 16
  %.14475 = getelementptr double, ptr %154, i64 %.14461
  %.14476 = load double, ptr %.14475, align 8
  %.14477 = fadd double %.14444, %.14476
  %.14500 = icmp slt i64 %.979, -3
  %.14501 = select i1 %.14500, i64 %arg.z.5.0, i64 0
  %155 = getelementptr i8, ptr %148, i64 24
  %.14515 = getelementptr double, ptr %155, i64 %.14501
  %.14516 = load double, ptr %.14515, align 8
  %.14517 = fcmp une double %.14516, 0.000000e+00
  br i1 %.14517, label %B9328, label %B9534
B9328:                                            ; preds = %B9204
  %sunkaddr677 = getelementptr i8, ptr %arg.control.4, i64 64
  %.14548 = load i64, ptr %sunkaddr677, align 8
  %.14582 = load i64, ptr %arg.clock.4, align 8
  %sunkaddr = getelementptr i8, ptr %arg.clock.4, i64 48
  %.14613 = load i64, ptr %sunkaddr, align 8
  %.14552 = add i64 %.1089, %.641
  %.14583 = add i64 %.14552, %.14548
  %.14614 = add i64 %.14583, %.14582
  %.14616 = add i64 %.14614, %.14613
  %.14668 = icmp slt i64 %.979, -4
  %.14669 = select i1 %.14668, i64 %arg.whole.5.0, i64 0
  %156 = getelementptr i64, ptr %arg.whole.4, i64 %.979
  %157 = getelementptr i8, ptr %156, i64 32
  %.14683 = getelementptr i64, ptr %157, i64 %.14669
  %.14684 = load i64, ptr %.14683, align 8
  store double 0.000000e+00, ptr %.14686, align 8
  %.14690 = call i32 @f78(ptr nonnull %.14686, ptr nonnull %excinfo.34, i64 %.14684, i64 %.1153, i64 %.14616)
  %cond = icmp eq i32 %.14690, 0
  br i1 %cond, label %B9328.endif, label %B9328.if.if
B9534:                                            ; preds = %B9328.endif, %B9204
  %value.6.5 = phi double [ %.14714, %B9328.endif ], [ %.14477, %B9204 ]
  %sunkaddr1236 = shl i64 %.14428, 3
  %sunkaddr1237 = getelementptr inbounds i8, ptr %153, i64 %sunkaddr1236
  store double %value.6.5, ptr %sunkaddr1237, align 8
  br label %B10170
B9572:                                            ; preds = %B9040
  %.14805 = icmp slt i64 %.979, 0
  %.14806 = select i1 %.14805, i64 %arg.z.5.0, i64 0
  %158 = getelementptr double, ptr %arg.z.4, i64 %.979
  %.14820 = getelementptr double, ptr %158, i64 %.14806
  %.14821 = load double, ptr %.14820, align 8
  %.14826 = icmp eq i64 %.1089, 1
  br i1 %.14826, label %B9600, label %B9642
B9600:                                            ; preds = %B9572
  %159 = icmp slt i64 %.979, 0
  %.14845 = select i1 %159, i64 %arg.whole.5.0, i64 0
  %160 = getelementptr i64, ptr %arg.whole.4, i64 %.979
  %.14859 = getelementptr i64, ptr %160, i64 %.14845
  %.14860 = load i64, ptr %.14859, align 8
  %.14863 = sitofp i64 %.14860 to double
  br label %B9642
B9642:                                            ; preds = %B9600, %B9572
  %value.7.4 = phi double [ %.14863, %B9600 ], [ %.14821, %B9572 ]
  %.14870.not = icmp eq i64 %.1153, 0
  %.14927 = icmp slt i64 %.1034, -1
  %.14928 = select i1 %.14927, i64 %arg.z.5.0, i64 0
  %161 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %162 = getelementptr i8, ptr %161, i64 8
  %.14942 = getelementptr double, ptr %162, i64 %.14928
  %.14943 = load double, ptr %.14942, align 8
  br i1 %.14870.not, label %B9690, label %B9646
B9646:                                            ; preds = %B9642
  %.14907 = fcmp ogt double %value.7.4, %.14943
  br i1 %.14907, label %B9738, label %B9736
B9690:                                            ; preds = %B9642
  %.14945 = fcmp olt double %value.7.4, %.14943
  br i1 %.14945, label %B9738, label %B9736
B9736:                                            ; preds = %B9690, %B9646
  br label %B9738
B9738:                                            ; preds = %B9736, %B9690, %B9646
  %"$phi9738.1.2.4" = phi double [ -1.000000e+00, %B9736 ], [ 1.000000e+00, %B9646 ], [ 1.000000e+00, %B9690 ]
  %.14977 = icmp slt i64 %.1034, 0
  %.14978 = select i1 %.14977, i64 %arg.z.5.0, i64 0
  %.14992 = getelementptr double, ptr %161, i64 %.14978
  %.14993 = load double, ptr %.14992, align 8
  %.14995 = fmul double %"$phi9738.1.2.4", %.14993
  %.14996 = fcmp olt double %.14995, 0.000000e+00
  %.15003 = fcmp ogt double %"$phi9738.1.2.4", 0.000000e+00
  %or.cond = and i1 %.15003, %.14996
  br i1 %or.cond, label %B9808, label %B9892
B9808:                                            ; preds = %B9738
  %.15026 = icmp slt i64 %.1034, -2
  %.15027 = select i1 %.15026, i64 %arg.z.5.0, i64 0
  %163 = getelementptr i8, ptr %161, i64 16
  %.15041 = getelementptr double, ptr %163, i64 %.15027
  %.15042 = load double, ptr %.15041, align 8
  %.15043 = fadd double %.15042, 1.000000e+00
  store double %.15043, ptr %.15041, align 8
  %sunkaddr678 = getelementptr i8, ptr %arg.control.4, i64 72
  store i64 -4611686018427387904, ptr %sunkaddr678, align 8
  br label %B9892
B9892:                                            ; preds = %B9808, %B9738
  %sunkaddr1239 = shl i64 %.14978, 3
  %sunkaddr1240 = getelementptr i8, ptr %161, i64 %sunkaddr1239
  store double %"$phi9738.1.2.4", ptr %sunkaddr1240, align 8
  br label %B10170
B9946:                                            ; preds = %B9040
  %.15176 = icmp sgt i64 %.915, -1
  br i1 %.15176, label %B9958, label %B9994
B9958:                                            ; preds = %B9946
  %164 = inttoptr i64 %.66.i.i to ptr
  %sunkaddr679 = getelementptr i8, ptr %arg.control.4, i64 96
  %.41.i.i = load i64, ptr %sunkaddr679, align 8
  %.6.i.i.i = inttoptr i64 %.41.i.i to ptr
  %.8.i.i.i = tail call i32 %.6.i.i.i(i32 1, ptr %164)
  %sunkaddr680 = getelementptr i8, ptr %arg.control.4, i64 200
  %.121.i.i = load i64, ptr %sunkaddr680, align 8
  %.122.i.i = mul nsw i64 %.121.i.i, 1000000000
  %sunkaddr681 = getelementptr i8, ptr %arg.control.4, i64 208
  %.151.i.i = load i64, ptr %sunkaddr681, align 8
  %.152.i.i = add nsw i64 %.122.i.i, %.151.i.i
  %sunkaddr682 = getelementptr i8, ptr %arg.control.4, i64 176
  %.79.i514 = load i64, ptr %sunkaddr682, align 8
  %.81.i = sub nsw i64 %.152.i.i, %.79.i514
  %sunkaddr683 = getelementptr i8, ptr %arg.control.4, i64 192
  %.111.i = load i64, ptr %sunkaddr683, align 8
  %.112.i = icmp sgt i64 %.81.i, %.111.i
  br i1 %.112.i, label %B96.i, label %_ZN8rovbrush12orchestrator4loop6pacing4markB3v62B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx.exit
B96.i:                                            ; preds = %B9958
  %sunkaddr684 = getelementptr i8, ptr %arg.control.4, i64 192
  store i64 %.81.i, ptr %sunkaddr684, align 8
  %sunkaddr685 = getelementptr i8, ptr %arg.control.4, i64 184
  store i64 %.915, ptr %sunkaddr685, align 8
  br label %_ZN8rovbrush12orchestrator4loop6pacing4markB3v62B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx.exit
_ZN8rovbrush12orchestrator4loop6pacing4markB3v62B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx.exit: ; preds = %B96.i, %B9958
  %sunkaddr686 = getelementptr i8, ptr %arg.control.4, i64 176
  store i64 %.152.i.i, ptr %sunkaddr686, align 8
  br label %B10170
B9994:                                            ; preds = %B9946
  %.15263 = load i64, ptr %arg.clock.4, align 8
  %sunkaddr687 = getelementptr i8, ptr %arg.clock.4, i64 48
  %.15294 = load i64, ptr %sunkaddr687, align 8
  %.15264 = add i64 %.979, %.641
  %.15295 = add i64 %.15264, %.15263
  %.15297 = add i64 %.15295, %.15294
  store i64 0, ptr %.15301, align 8
  %.15307 = call i32 @f79(ptr nonnull %.15301, ptr nonnull %excinfo.36, ptr %arg.control.0, ptr %arg.control.1, i64 %arg.control.2, i64 %arg.control.3, ptr %arg.control.4, i64 %arg.control.5.0, i64 %arg.control.6.0, i64 %.15297)
  %cond541 = icmp eq i32 %.15307, 0
  br i1 %cond541, label %B9994.endif, label %B9994.if.if
B10120:                                           ; preds = %B9994.endif
  %.15424 = getelementptr i8, ptr %arg.control.4, i64 8
  store i64 %.745, ptr %.15424, align 8
  %.15457 = getelementptr i8, ptr %arg.control.4, i64 16
  store i64 %.509.0, ptr %.15457, align 8
  store i64 %.15317, ptr %retptr, align 8
  br label %common.ret
B10170:                                           ; preds = %B277.i, %B2578, %B5762, %B5762.us, %B9994.endif, %B7156.else.if, %B7000.endif.endif, %B6650.endif.endif, %B6464.endif, %B5762.us.prol.loopexit, %middle.block, %B5762.prol.loopexit, %middle.block914, %B5730.endif, %B5624.endif.endif, %B5478.endif.endif.endif, %B2784.endif, %B2608.endif, %B1452.endif, %B884.endif, %_ZN8rovbrush12orchestrator4loop6pacing4markB3v62B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx.exit, %B9892, %B9534, %B9154, %B9112, %B9040, %B8908, %B8818, %B8550, %B8502, %B8170, %B7672, %B7506, %B7224, %B6894, %B6858, %B6730, %B6528, %B6406, %B6270, %B5300, %B5054, %B4956, %B4802, %B4672, %B4416, %B3752, %B3704, %B3504, %B3398, %B3292, %B3142, %B3052, %B2988, %B240.endif.i
  %base.4.3 = phi i64 [ %base.3.1, %B9040 ], [ %base.3.1, %B2988 ], [ %base.3.1, %B1452.endif ], [ %base.3.1, %B2608.endif ], [ %base.3.1, %B9154 ], [ %base.3.1, %B3052 ], [ %base.3.1, %B3142 ], [ %base.3.1, %B3292 ], [ %base.3.1, %B3398 ], [ %base.3.1, %B3504 ], [ %base.3.1, %B3704 ], [ %base.3.1, %B3752 ], [ %base.3.1, %B2784.endif ], [ %base.3.1, %B4672 ], [ %base.3.1, %B4802 ], [ %base.3.1, %B4956 ], [ %base.3.1, %B5054 ], [ %base.3.1, %B5300 ], [ %base.3.1, %B5478.endif.endif.endif ], [ %base.3.1, %B5624.endif.endif ], [ %base.3.1, %B4416 ], [ %base.3.1, %B5730.endif ], [ %base.3.1, %B6406 ], [ %base.3.1, %B6528 ], [ %base.3.1, %B240.endif.i ], [ %base.3.1, %B6730 ], [ %base.3.1, %B6464.endif ], [ %base.3.1, %B6858 ], [ %base.3.1, %middle.block ], [ %base.3.1, %B7000.endif.endif ], [ %base.3.1, %B7156.else.if ], [ %.11872, %B7224 ], [ %base.3.1, %B7506 ], [ %.12322, %B7672 ], [ %base.3.1, %B6650.endif.endif ], [ %base.3.1, %B8170 ], [ %base.3.1, %B8818 ], [ %base.3.1, %B8908 ], [ %base.3.1, %B9112 ], [ %base.3.1, %B8550 ], [ %base.3.1, %B9892 ], [ %base.3.1, %middle.block914 ], [ %base.3.1, %B9994.endif ], [ %base.3.1, %B8502 ], [ %base.3.1, %B9534 ], [ %base.3.1, %B884.endif ], [ %base.3.1, %B6270 ], [ %base.3.1, %B6894 ], [ %base.3.1, %_ZN8rovbrush12orchestrator4loop6pacing4markB3v62B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx.exit ], [ %base.3.1, %B5762.us.prol.loopexit ], [ %base.3.1, %B5762.prol.loopexit ], [ %base.3.1, %B5762 ], [ %base.3.1, %B2578 ], [ %base.3.1, %B5762.us ], [ %base.3.1, %B277.i ]
  %m.7.3 = phi i64 [ %.745, %B9040 ], [ %.745, %B2988 ], [ %.745, %B1452.endif ], [ %.745, %B2608.endif ], [ %.745, %B9154 ], [ %.745, %B3052 ], [ %.745, %B3142 ], [ %.745, %B3292 ], [ %.745, %B3398 ], [ %.745, %B3504 ], [ %.745, %B3704 ], [ %.745, %B3752 ], [ %.745, %B2784.endif ], [ %.745, %B4672 ], [ %.745, %B4802 ], [ %.745, %B4956 ], [ %.745, %B5054 ], [ %.745, %B5300 ], [ %.745, %B5478.endif.endif.endif ], [ %.745, %B5624.endif.endif ], [ %.745, %B4416 ], [ %.745, %B5730.endif ], [ %.745, %B6406 ], [ %.10646, %B6528 ], [ %.745, %B240.endif.i ], [ %.11040, %B6730 ], [ %.745, %B6464.endif ], [ %.11219, %B6858 ], [ %.745, %middle.block ], [ %.745, %B7000.endif.endif ], [ %.745, %B7156.else.if ], [ %.745, %B7224 ], [ %.12236, %B7506 ], [ %.745, %B7672 ], [ %.745, %B6650.endif.endif ], [ %.745, %B8170 ], [ %.745, %B8818 ], [ %.745, %B8908 ], [ %.745, %B9112 ], [ %.745, %B8550 ], [ %.745, %B9892 ], [ %.745, %middle.block914 ], [ %.745, %B9994.endif ], [ %.745, %B8502 ], [ %.745, %B9534 ], [ %.745, %B884.endif ], [ %.745, %B6270 ], [ %.745, %B6894 ], [ %.745, %_ZN8rovbrush12orchestrator4loop6pacing4markB3v62B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx.exit ], [ %.745, %B5762.us.prol.loopexit ], [ %.745, %B5762.prol.loopexit ], [ %.745, %B5762 ], [ %.745, %B2578 ], [ %.745, %B5762.us ], [ %.745, %B277.i ]
  %.15490 = add nsw i64 %m.7.3, 1
  %.15506 = icmp slt i64 %.15490, %arg.operations.5.0
  br i1 %.15506, label %B362, label %B10212
B10212:                                           ; preds = %B10170, %B206
  %165 = icmp eq i64 %arg.cycle_ticks, 0
  br i1 %165, label %B10224.endif, label %B10352
B10334:                                           ; preds = %B10224.endif
  store i64 0, ptr %retptr, align 8
  br label %common.ret
B10352:                                           ; preds = %B10224.endif, %B10212
  %.568 = icmp sgt i64 %.56711337, 1
  br i1 %.568, label %B206, label %B10356
B10356:                                           ; preds = %B10352, %B116.endif
  store i64 0, ptr %retptr, align 8
  br label %common.ret
B116.endif:                                       ; preds = %B38, %B0
  %"$phi116.0.2.0" = phi double [ %.401, %B38 ], [ 1.000000e+300, %B0 ]
  %.443 = getelementptr i8, ptr %arg.control.4, i64 40
  %.444 = load i64, ptr %.443, align 8
  store i64 0, ptr %.443, align 8
  %.56811334.not = icmp slt i64 %arg.cycles, 1
  br i1 %.56811334.not, label %B10356, label %B206.lr.ph
B206.lr.ph:                                       ; preds = %B116.endif
  %166 = ptrtoint ptr %arg.saved.4 to i64
  %167 = ptrtoint ptr %arg.z.4 to i64
  %.9206 = sitofp i64 %arg.denominator to double
  %.11915 = shl i64 %arg.numerator, 1
  %.64.i.i = ptrtoint ptr %arg.control.4 to i64
  %.66.i.i = add nsw i64 %.64.i.i, 200
  %168 = sub i64 %166, %167
  %169 = sub i64 %167, %166
  %170 = shl i64 %arg.slots.5.0, 3
  %171 = shl i64 %arg.buffer.5.0, 3
  %172 = shl i64 %arg.coefficients.5.0, 3
  %173 = shl i64 %arg.z.5.0, 3
  br label %B206
B884.endif:                                       ; preds = %B884
  %174 = inttoptr i64 %.1810 to ptr
  %.10.i.i = trunc i64 %.1920 to i32
  %.11.i.i = inttoptr i64 %.1865 to ptr
  %.12.i.i = tail call i32 %174(ptr %.11.i.i, double %.1617, double %length.6.3, i32 %.10.i.i)
  %.6.i517 = icmp ugt i32 %.12.i.i, 1
  br i1 %.6.i517, label %B1086.split.loop.exit638, label %B10170
B1452.endif:                                      ; preds = %B1392, %B1308, %B1204
  %last.3.4.in = phi ptr [ %.2513, %B1308 ], [ %.2645, %B1392 ], [ %.2385, %B1204 ]
  %first.4.4.in = phi ptr [ %.2458, %B1308 ], [ %.2590, %B1392 ], [ %.2330, %B1204 ]
  %first.4.4 = load i64, ptr %first.4.4.in, align 8
  %last.3.4 = load i64, ptr %last.3.4.in, align 8
  %.2694 = sub i64 %last.3.4, %first.4.4
  %.273811276.not = icmp slt i64 %.2694, 1
  br i1 %.273811276.not, label %B10170, label %B1488.preheader
B1488.preheader:                                  ; preds = %B1452.endif
  br label %B1488
B1560.endif:                                      ; preds = %B1560
  %.2874 = load i64, ptr %.2846, align 8
  %.2888 = icmp sgt i64 %.2874, -1
  br i1 %.2888, label %B1614, label %B1698
B1560.if.if:                                      ; preds = %B1560
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
B1698.endif:                                      ; preds = %B122.endif.i, %B66.endif.i, %B16.endif.i442
  %.14.i8.sink.i = phi i32 [ %.14.i8.i, %B122.endif.i ], [ %.16.i.i441, %B66.endif.i ], [ %.13.i.i446, %B16.endif.i442 ]
  %.7.i519 = icmp ugt i32 %.14.i8.sink.i, 1
  br i1 %.7.i519, label %B2172.loopexit, label %B1980
B2050.endif:                                      ; preds = %B2050
  %.3627 = load i64, ptr %.3597, align 8
  %.3641 = icmp sgt i64 %.3627, -1
  br i1 %.3641, label %B2142.thread, label %B2278
B2050.if.if:                                      ; preds = %B2050
  %.3625 = icmp sgt i32 %.3617, 0
  %.3618 = load ptr, ptr %excinfo.8, align 8
  %.3626 = select i1 %.3625, ptr %.3618, ptr undef
  store ptr %.3626, ptr %excinfo, align 8
  br label %common.ret
B2326.endif:                                      ; preds = %B2278
  %sunkaddr688 = mul i64 %.3112, 8
  %sunkaddr689 = getelementptr i8, ptr %arg.blocks.4, i64 %sunkaddr688
  %sunkaddr690 = getelementptr i8, ptr %sunkaddr689, i64 40
  %.4005 = load i64, ptr %sunkaddr690, align 8
  %sunkaddr691 = mul i64 %.3112, 8
  %sunkaddr692 = getelementptr i8, ptr %arg.blocks.4, i64 %sunkaddr691
  %sunkaddr693 = getelementptr i8, ptr %sunkaddr692, i64 32
  %.4117 = load i64, ptr %sunkaddr693, align 8
  %..4117 = tail call i64 @llvm.smax.i64(i64 %.4117, i64 0)
  br label %B2442
B2608.endif:                                      ; preds = %B2608
  %.4561 = load i64, ptr %.4529, align 8
  %.4581.not = icmp eq i64 %.4561, 0
  br i1 %.4581.not, label %B10170, label %B2708
B2608.if.if:                                      ; preds = %B2608
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
B2784.endif:                                      ; preds = %B742
  %sunkaddr694 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.4773 = load i64, ptr %sunkaddr694, align 8
  %.11.i = inttoptr i64 %.979 to ptr
  %.12.i447 = inttoptr i64 %.1034 to ptr
  %.13.i = tail call i64 %.11.i(ptr %.12.i447, i64 %base.3.1, i64 %.4773, i64 %arg.numerator, i64 %arg.denominator, double %"$phi116.0.2.0")
  %.4812.not = icmp eq i64 %.13.i, 0
  br i1 %.4812.not, label %B10170, label %B2870
B4250.endif:                                      ; preds = %B4188, %B4168
  %cell.4.5 = phi i64 [ %.6860, %B4188 ], [ %.6826, %B4168 ]
  %.6875 = icmp eq i64 %.1153, 0
  %.696711294.not = icmp slt i64 %.1153, 1
  br i1 %.696711294.not, label %B4416, label %B4314.lr.ph
B4314.lr.ph:                                      ; preds = %B4250.endif
  %.6873 = and i64 %cell.4.5, 4294967295
  %.6871 = ashr i64 %cell.4.5, 32
  %.7052 = sitofp i64 %.6871 to double
  %.7058 = add i64 %.1208, 5
  %.7095 = uitofp i64 %.6873 to double
  br label %B4314
B4506.endif:                                      ; preds = %B742
  %.7361 = icmp slt i64 %.979, 0
  %.7362 = select i1 %.7361, i64 %arg.groups.5.0, i64 0
  %.7363 = add i64 %.7362, %.979
  %.7383 = mul i64 %.7363, %arg.groups.5.1
  %.7387 = getelementptr i64, ptr %arg.groups.4, i64 %.7383
  %.7388 = load i64, ptr %.7387, align 8
  %.7442 = getelementptr i8, ptr %.7387, i64 8
  %.7443 = load i64, ptr %.7442, align 8
  %.7500 = getelementptr i8, ptr %.7387, i64 16
  %.7501 = load i64, ptr %.7500, align 8
  %.7517 = select i1 %.7361, i64 %arg.rows.5.0, i64 0
  %175 = getelementptr i64, ptr %arg.rows.4, i64 %.979
  %.7531 = getelementptr i64, ptr %175, i64 %.7517
  %.7532 = load i64, ptr %.7531, align 8
  %.7533 = mul i64 %.7532, %.7443
  %.7534 = add i64 %.7533, %.7501
  %.761711286.not = icmp slt i64 %.7443, 1
  br i1 %.761711286.not, label %B4506.endif.B4672_crit_edge, label %B4622.preheader
B4506.endif.B4672_crit_edge:                      ; preds = %B4506.endif
  %.pre250 = shl i64 %.7517, 3
  br label %B4672
B4622.preheader:                                  ; preds = %B4506.endif
  %176 = icmp eq i64 %.7443, 1
  br i1 %176, label %B4622.epil.preheader, label %B4622.preheader.new
B4622.preheader.new:                              ; preds = %B4622.preheader
  %const626 = bitcast i64 9223372036854775804 to i64
  %const_mat627 = add i64 %const626, 2
  %unroll_iter = and i64 %.7443, %const_mat627
  %177 = shl i64 %.7388, 3
  %scevgep = getelementptr i8, ptr %arg.slots.4, i64 %177
  %178 = shl i64 %.7534, 3
  %scevgep1094 = getelementptr i8, ptr %arg.buffer.4, i64 %178
  br label %B4622
B5478.endif.endif.endif:                          ; preds = %B5478
  %.9128 = load double, ptr %.9112, align 8
  %.9154 = icmp slt i64 %.1034, 0
  %.9155 = select i1 %.9154, i64 %arg.z.5.0, i64 0
  %179 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.9169 = getelementptr double, ptr %179, i64 %.9155
  store double %.9128, ptr %.9169, align 8
  br label %B10170
B5478.endif.endif.if.if:                          ; preds = %B5478
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
B5624.endif.endif:                                ; preds = %B68.else.if.i.i, %B0.endif.common.ret_crit_edge.i
  %.15.pre-phi.i = phi i64 [ %.pre.i, %B0.endif.common.ret_crit_edge.i ], [ %.143.i.i, %B68.else.if.i.i ]
  %low.4.1.i.i = phi i64 [ 0, %B0.endif.common.ret_crit_edge.i ], [ %low.3.1.i.i, %B68.else.if.i.i ]
  %.71.i81 = add nsw i64 %.15.pre-phi.i, %.5.i.i
  %.98.i = add nsw i64 %.71.i81, %low.4.1.i.i
  %.111.i82 = icmp slt i64 %.98.i, 0
  %.112.i83 = select i1 %.111.i82, i64 %arg.coefficients.5.0, i64 0
  %180 = getelementptr double, ptr %arg.coefficients.4, i64 %.98.i
  %.126.i = getelementptr double, ptr %180, i64 %.112.i83
  %.127.i = load double, ptr %.126.i, align 8
  %.9255 = icmp slt i64 %.1034, 0
  %.9256 = select i1 %.9255, i64 %arg.z.5.0, i64 0
  %181 = getelementptr double, ptr %arg.z.4, i64 %.1034
  %.9270 = getelementptr double, ptr %181, i64 %.9256
  store double %.127.i, ptr %.9270, align 8
  br label %B10170
B5730.endif:                                      ; preds = %B5718
  %.941511303.not = icmp slt i64 %.979, 1
  br i1 %.941511303.not, label %B10170, label %B5762.lr.ph
B5762.lr.ph:                                      ; preds = %B5730.endif
  %182 = icmp eq i64 %.805, 14
  br i1 %182, label %B5762.us.preheader, label %B5762.preheader
B5762.preheader:                                  ; preds = %B5762.lr.ph
  %183 = icmp ult i64 %.979, 4
  %184 = icmp ult i64 %169, 32
  %or.cond917 = select i1 %183, i1 true, i1 %184
  br i1 %or.cond917, label %B5762.preheader920, label %vector.ph906
vector.ph906:                                     ; preds = %B5762.preheader
  %const628 = bitcast i64 9223372036854775804 to i64
  %n.vec908 = and i64 %.979, %const628
  br label %vector.body909
vector.body909:                                   ; preds = %vector.body909, %vector.ph906
  %index910 = phi i64 [ 0, %vector.ph906 ], [ %index.next913, %vector.body909 ]
  %sunkaddr695 = mul i64 %index910, 8
  %sunkaddr696 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr695
  %wide.load911 = load <2 x double>, ptr %sunkaddr696, align 8
  %sunkaddr697 = mul i64 %index910, 8
  %sunkaddr698 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr697
  %sunkaddr699 = getelementptr i8, ptr %sunkaddr698, i64 16
  %wide.load912 = load <2 x double>, ptr %sunkaddr699, align 8
  %sunkaddr700 = mul i64 %index910, 8
  %sunkaddr701 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr700
  store <2 x double> %wide.load911, ptr %sunkaddr701, align 8
  %sunkaddr702 = mul i64 %index910, 8
  %sunkaddr703 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr702
  %sunkaddr704 = getelementptr i8, ptr %sunkaddr703, i64 16
  store <2 x double> %wide.load912, ptr %sunkaddr704, align 8
  %index.next913 = add nuw nsw i64 %index910, 4
  %185 = icmp eq i64 %n.vec908, %index.next913
  br i1 %185, label %middle.block914, label %vector.body909
middle.block914:                                  ; preds = %vector.body909
  %cmp.n915 = icmp eq i64 %.979, %n.vec908
  br i1 %cmp.n915, label %B10170, label %B5762.preheader920
B5762.preheader920:                               ; preds = %middle.block914, %B5762.preheader
  %.94211130211304.ph = phi i64 [ 0, %B5762.preheader ], [ %n.vec908, %middle.block914 ]
  %xtraiter1003 = and i64 %.979, 3
  %lcmp.mod1004.not = icmp eq i64 %xtraiter1003, 0
  br i1 %lcmp.mod1004.not, label %B5762.prol.loopexit, label %B5762.prol.preheader
B5762.prol.preheader:                             ; preds = %B5762.preheader920
  br label %B5762.prol
B5762.prol:                                       ; preds = %B5762.prol.preheader, %B5762.prol
  %lsr.iv1121 = phi i64 [ %lsr.iv.next1122, %B5762.prol ], [ %xtraiter1003, %B5762.prol.preheader ]
  %.94211130211304.prol = phi i64 [ %.9428.prol, %B5762.prol ], [ %.94211130211304.ph, %B5762.prol.preheader ]
  %.9428.prol = add nuw nsw i64 %.94211130211304.prol, 1
  %186 = shl i64 %.94211130211304.prol, 3
  %scevgep1120 = getelementptr i8, ptr %arg.saved.4, i64 %186
  %.9554.prol = load double, ptr %scevgep1120, align 8
  %scevgep1119 = getelementptr i8, ptr %arg.z.4, i64 %186
  store double %.9554.prol, ptr %scevgep1119, align 8
  %lsr.iv.next1122 = add nsw i64 %lsr.iv1121, -1
  %prol.iter.cmp.not = icmp eq i64 %lsr.iv.next1122, 0
  br i1 %prol.iter.cmp.not, label %B5762.prol.loopexit, label %B5762.prol
B5762.prol.loopexit:                              ; preds = %B5762.prol, %B5762.preheader920
  %.94211130211304.unr = phi i64 [ %.94211130211304.ph, %B5762.preheader920 ], [ %.9428.prol, %B5762.prol ]
  %187 = sub nsw i64 %.94211130211304.ph, %.979
  %188 = icmp ugt i64 %187, -4
  br i1 %188, label %B10170, label %B5762.preheader569
B5762.preheader569:                               ; preds = %B5762.prol.loopexit
  br label %B5762
B5762.us.preheader:                               ; preds = %B5762.lr.ph
  %189 = icmp ult i64 %.979, 4
  %190 = icmp ult i64 %168, 32
  %or.cond918 = select i1 %189, i1 true, i1 %190
  br i1 %or.cond918, label %B5762.us.preheader919, label %vector.ph
vector.ph:                                        ; preds = %B5762.us.preheader
  %const629 = bitcast i64 9223372036854775804 to i64
  %n.vec = and i64 %.979, %const629
  br label %vector.body
vector.body:                                      ; preds = %vector.body, %vector.ph
  %index = phi i64 [ 0, %vector.ph ], [ %index.next, %vector.body ]
  %sunkaddr705 = mul i64 %index, 8
  %sunkaddr706 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr705
  %wide.load = load <2 x double>, ptr %sunkaddr706, align 8
  %sunkaddr707 = mul i64 %index, 8
  %sunkaddr708 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr707
  %sunkaddr709 = getelementptr i8, ptr %sunkaddr708, i64 16
  %wide.load900 = load <2 x double>, ptr %sunkaddr709, align 8
  %sunkaddr710 = mul i64 %index, 8
  %sunkaddr711 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr710
  store <2 x double> %wide.load, ptr %sunkaddr711, align 8
  %sunkaddr712 = mul i64 %index, 8
  %sunkaddr713 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr712
  %sunkaddr714 = getelementptr i8, ptr %sunkaddr713, i64 16
  store <2 x double> %wide.load900, ptr %sunkaddr714, align 8
  %index.next = add nuw nsw i64 %index, 4
  %191 = icmp eq i64 %n.vec, %index.next
  br i1 %191, label %middle.block, label %vector.body
middle.block:                                     ; preds = %vector.body
  %cmp.n = icmp eq i64 %.979, %n.vec
  br i1 %cmp.n, label %B10170, label %B5762.us.preheader919
B5762.us.preheader919:                            ; preds = %middle.block, %B5762.us.preheader
  %.94211130211304.us.ph = phi i64 [ 0, %B5762.us.preheader ], [ %n.vec, %middle.block ]
  %xtraiter1005 = and i64 %.979, 3
  %lcmp.mod1006.not = icmp eq i64 %xtraiter1005, 0
  br i1 %lcmp.mod1006.not, label %B5762.us.prol.loopexit, label %B5762.us.prol.preheader
B5762.us.prol.preheader:                          ; preds = %B5762.us.preheader919
  br label %B5762.us.prol
B5762.us.prol:                                    ; preds = %B5762.us.prol.preheader, %B5762.us.prol
  %lsr.iv1147 = phi i64 [ %lsr.iv.next1148, %B5762.us.prol ], [ %xtraiter1005, %B5762.us.prol.preheader ]
  %.94211130211304.us.prol = phi i64 [ %.9428.us.prol, %B5762.us.prol ], [ %.94211130211304.us.ph, %B5762.us.prol.preheader ]
  %.9428.us.prol = add nuw nsw i64 %.94211130211304.us.prol, 1
  %192 = shl i64 %.94211130211304.us.prol, 3
  %scevgep1146 = getelementptr i8, ptr %arg.z.4, i64 %192
  %.9489.us.prol = load double, ptr %scevgep1146, align 8
  %scevgep1145 = getelementptr i8, ptr %arg.saved.4, i64 %192
  store double %.9489.us.prol, ptr %scevgep1145, align 8
  %lsr.iv.next1148 = add nsw i64 %lsr.iv1147, -1
  %prol.iter1007.cmp.not = icmp eq i64 %lsr.iv.next1148, 0
  br i1 %prol.iter1007.cmp.not, label %B5762.us.prol.loopexit, label %B5762.us.prol
B5762.us.prol.loopexit:                           ; preds = %B5762.us.prol, %B5762.us.preheader919
  %.94211130211304.us.unr = phi i64 [ %.94211130211304.us.ph, %B5762.us.preheader919 ], [ %.9428.us.prol, %B5762.us.prol ]
  %193 = sub nsw i64 %.94211130211304.us.ph, %.979
  %194 = icmp ugt i64 %193, -4
  br i1 %194, label %B10170, label %B5762.us.preheader568
B5762.us.preheader568:                            ; preds = %B5762.us.prol.loopexit
  br label %B5762.us
B5762.us:                                         ; preds = %B5762.us.preheader568, %B5762.us
  %.94211130211304.us = phi i64 [ %.9428.us.3, %B5762.us ], [ %.94211130211304.us.unr, %B5762.us.preheader568 ]
  %sunkaddr715 = mul i64 %.94211130211304.us, 8
  %sunkaddr716 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr715
  %.9489.us = load double, ptr %sunkaddr716, align 8
  %sunkaddr717 = mul i64 %.94211130211304.us, 8
  %sunkaddr718 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr717
  store double %.9489.us, ptr %sunkaddr718, align 8
  %sunkaddr719 = mul i64 %.94211130211304.us, 8
  %sunkaddr720 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr719
  %sunkaddr721 = getelementptr i8, ptr %sunkaddr720, i64 8
  %.9489.us.1 = load double, ptr %sunkaddr721, align 8
  %sunkaddr722 = mul i64 %.94211130211304.us, 8
  %sunkaddr723 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr722
  %sunkaddr724 = getelementptr i8, ptr %sunkaddr723, i64 8
  store double %.9489.us.1, ptr %sunkaddr724, align 8
  %sunkaddr725 = mul i64 %.94211130211304.us, 8
  %sunkaddr726 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr725
  %sunkaddr727 = getelementptr i8, ptr %sunkaddr726, i64 16
  %.9489.us.2 = load double, ptr %sunkaddr727, align 8
  %sunkaddr728 = mul i64 %.94211130211304.us, 8
  %sunkaddr729 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr728
  %sunkaddr730 = getelementptr i8, ptr %sunkaddr729, i64 16
  store double %.9489.us.2, ptr %sunkaddr730, align 8
  %.9428.us.3 = add nuw nsw i64 %.94211130211304.us, 4
  %sunkaddr731 = mul i64 %.94211130211304.us, 8
  %sunkaddr732 = getelementptr i8, ptr %arg.z.4, i64 %sunkaddr731
  %sunkaddr733 = getelementptr i8, ptr %sunkaddr732, i64 24
  %.9489.us.3 = load double, ptr %sunkaddr733, align 8
  %sunkaddr734 = mul i64 %.94211130211304.us, 8
  %sunkaddr735 = getelementptr i8, ptr %arg.saved.4, i64 %sunkaddr734
  %sunkaddr736 = getelementptr i8, ptr %sunkaddr735, i64 24
  store double %.9489.us.3, ptr %sunkaddr736, align 8
  %exitcond11783.not.3 = icmp eq i64 %.979, %.9428.us.3
  br i1 %exitcond11783.not.3, label %B10170, label %B5762.us
B5934.endif:                                      ; preds = %B5872
  %.9752 = mul i64 %.915, %arg.state_calls.5.1
  %195 = getelementptr i64, ptr %arg.state_calls.4, i64 %.9752
  %.9756 = getelementptr i8, ptr %195, i64 8
  %.9757 = load i64, ptr %.9756, align 8
  %.9807 = mul i64 %.915, %arg.components.5.1
  %196 = getelementptr i64, ptr %arg.components.4, i64 %.9807
  %.9811 = getelementptr i8, ptr %196, i64 8
  %.9812 = load i64, ptr %.9811, align 8
  %197 = getelementptr i64, ptr %arg.states.4, i64 %.915
  %.9843 = load i64, ptr %197, align 8
  %.7.i460 = inttoptr i64 %.9757 to ptr
  %.8.i = inttoptr i64 %.9812 to ptr
  %.9.i = inttoptr i64 %.9843 to ptr
  %.10.i = tail call i32 %.7.i460(ptr %.8.i, ptr %.9.i)
  br label %B6270
B6184.endif:                                      ; preds = %B6154, %B6034.B6184.endif_crit_edge
  %.9.i469.pre-phi = phi ptr [ %.pre724, %B6034.B6184.endif_crit_edge ], [ %.9.i463, %B6154 ]
  %.10230.pre-phi = phi i64 [ %.pre723, %B6034.B6184.endif_crit_edge ], [ %.10018, %B6154 ]
  %.10177 = getelementptr i64, ptr %arg.state_calls.4, i64 %.pre
  %.10178 = load i64, ptr %.10177, align 8
  %198 = getelementptr i64, ptr %arg.components.4, i64 %.10230.pre-phi
  %.10234 = getelementptr i8, ptr %198, i64 8
  %.10235 = load i64, ptr %.10234, align 8
  %.7.i467 = inttoptr i64 %.10178 to ptr
  %.8.i468 = inttoptr i64 %.10235 to ptr
  %.10.i470 = tail call i32 %.7.i467(ptr %.8.i468, ptr %.9.i469.pre-phi)
  br label %B6270
B6464.endif:                                      ; preds = %B6464
  %.10612 = load i64, ptr %.10592, align 8
  switch i64 %.10612, label %B6564 [
    i64 0, label %B6528
    i64 1, label %B10170
  ]
B6464.if.if:                                      ; preds = %B6464
  %.10610 = icmp sgt i32 %.10602, 0
  %.10603 = load ptr, ptr %excinfo.23, align 8
  %.10611 = select i1 %.10610, ptr %.10603, ptr undef
  store ptr %.10611, ptr %excinfo, align 8
  br label %common.ret
B6650.else:                                       ; preds = %B6384
  %.10846 = icmp slt i64 %.915, 0
  %.10847 = select i1 %.10846, i64 %arg.solver.5.0, i64 0
  %.10848 = add i64 %.10847, %.915
  %.10851 = icmp slt i64 %.10848, 0
  br i1 %.10851, label %B6650.else.if, label %B6650.else.endif
B6650.endif:                                      ; preds = %B6650.else.endif.if, %B6650.else.endif
  %.10836.sroa.0.3 = phi i64 [ %arg.solver.5.0, %B6650.else.endif.if ], [ %.10836.sroa.0.1, %B6650.else.endif ]
  %.10924 = sub i64 %arg.solver.5.0, %.10836.sroa.0.3
  %.10933 = tail call i64 @llvm.smax.i64(i64 %.10924, i64 0)
  %.10949 = getelementptr double, ptr %arg.solver.4, i64 %.10836.sroa.0.3
  store i64 0, ptr %.10984, align 8
  %.10994 = call i32 @f74(ptr nonnull %.10984, ptr nonnull %excinfo.24, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %.1034, i64 %.1089, i64 %.1153, ptr %arg.coefficients.0, ptr %arg.coefficients.1, i64 %arg.coefficients.2, i64 %arg.coefficients.3, ptr %arg.coefficients.4, i64 %arg.coefficients.5.0, i64 %arg.coefficients.6.0, i64 %.1208, ptr %arg.solver.0, ptr %arg.solver.1, i64 %.10933, i64 %arg.solver.3, ptr %.10949, i64 %.10933, i64 %arg.solver.6.0)
  %cond543 = icmp eq i32 %.10994, 0
  br i1 %cond543, label %B6650.endif.endif, label %B6650.endif.if.if
B6650.else.if:                                    ; preds = %B6650.else
  br label %B6650.else.endif
B6650.else.endif:                                 ; preds = %B6650.else.if, %B6650.else
  %.10836.sroa.0.1 = phi i64 [ 0, %B6650.else.if ], [ %.10848, %B6650.else ]
  %.10856.not = icmp slt i64 %.10848, %arg.solver.5.0
  br i1 %.10856.not, label %B6650.endif, label %B6650.else.endif.if
B6650.else.endif.if:                              ; preds = %B6650.else.endif
  br label %B6650.endif
B6650.endif.endif:                                ; preds = %B6650.endif
  %.11004 = load i64, ptr %.10984, align 8
  switch i64 %.11004, label %B6772 [
    i64 1, label %B6730
    i64 0, label %B10170
  ]
B6650.endif.if.if:                                ; preds = %B6650.endif
  %.11002 = icmp sgt i32 %.10994, 0
  %.10995 = load ptr, ptr %excinfo.24, align 8
  %.11003 = select i1 %.11002, ptr %.10995, ptr undef
  store ptr %.11003, ptr %excinfo, align 8
  br label %common.ret
B7000.endif.endif:                                ; preds = %B7000
  %.11452 = load double, ptr %.11432, align 8
  %.11479 = icmp slt i64 %.979, -2
  %.11480 = select i1 %.11479, i64 %arg.z.5.0, i64 0
  %199 = getelementptr i8, ptr %127, i64 16
  %.11494 = getelementptr double, ptr %199, i64 %.11480
  store double %.11452, ptr %.11494, align 8
  %.11525 = load i64, ptr %arg.clock.4, align 8
  %.11540 = icmp slt i64 %.979, 0
  %.11541 = select i1 %.11540, i64 %arg.z.5.0, i64 0
  %.11555 = getelementptr double, ptr %127, i64 %.11541
  %.11556 = sitofp i64 %.11525 to double
  store double %.11556, ptr %.11555, align 8
  br label %B10170
B7000.endif.if.if:                                ; preds = %B7000
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
B7156.else.if:                                    ; preds = %B6384
  %sunkaddr737 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.11619 = load i64, ptr %sunkaddr737, align 8
  %.11627.1 = ashr i64 %.11619, 1
  store i64 %.11627.1, ptr %sunkaddr737, align 8
  br label %B10170
B7386.endif.endif:                                ; preds = %B7386
  %.11986 = load i64, ptr %.11964, align 8
  switch i64 %.11986, label %B7742 [
    i64 0, label %B7506
    i64 1, label %B7672
  ]
B7386.endif.if.if:                                ; preds = %B7386
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
B8220.endif:                                      ; preds = %B8220
  %.13147 = load i64, ptr %.13133, align 8
  %.6.i521 = icmp ugt i64 %.13147, 1
  br i1 %.6.i521, label %B8422, label %B8502
B8220.if.if:                                      ; preds = %B8220
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
B9328.endif:                                      ; preds = %B9328
  %.14700 = load double, ptr %.14686, align 8
  %.14712 = fmul double %.14516, %.14700
  %.14714 = fadd double %.14477, %.14712
  br label %B9534
B9328.if.if:                                      ; preds = %B9328
  %.14698 = icmp sgt i32 %.14690, 0
  %.14691 = load ptr, ptr %excinfo.34, align 8
  %.14699 = select i1 %.14698, ptr %.14691, ptr undef
  store ptr %.14699, ptr %excinfo, align 8
  br label %common.ret
B9994.endif:                                      ; preds = %B9994
  %.15317 = load i64, ptr %.15301, align 8
  %.15331.not = icmp eq i64 %.15317, 0
  br i1 %.15331.not, label %B10170, label %B10120
B9994.if.if:                                      ; preds = %B9994
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
B10224.endif:                                     ; preds = %B10212
  %.15553 = load i64, ptr %arg.clock.4, align 8
  %sunkaddr738 = getelementptr i8, ptr %arg.clock.4, i64 40
  %.15583 = load i64, ptr %sunkaddr738, align 8
  %sunkaddr739 = getelementptr i8, ptr %arg.control.4, i64 56
  %.15613 = load i64, ptr %sunkaddr739, align 8
  %.11.i516 = tail call i64 @llvm.smin.i64(i64 %.15613, i64 %.15583)
  %.15642.not = icmp slt i64 %.15553, %.11.i516
  br i1 %.15642.not, label %B10352, label %B10334
}
define linkonce_odr noundef i32 @f70(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.blocks.0, ptr readnone %arg.blocks.1, i64 %arg.blocks.2, i64 %arg.blocks.3, ptr readonly %arg.blocks.4, i64 %arg.blocks.5.0, i64 %arg.blocks.5.1, i64 %arg.blocks.6.0, i64 %arg.blocks.6.1, i64 %arg.m, ptr readnone %arg.z.0, ptr readnone %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr readonly %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr readnone %arg.whole.0, ptr readnone %arg.whole.1, i64 %arg.whole.2, i64 %arg.whole.3, ptr readonly %arg.whole.4, i64 %arg.whole.5.0, i64 %arg.whole.6.0, ptr readnone %arg.raw.0, ptr readnone %arg.raw.1, i64 %arg.raw.2, i64 %arg.raw.3, ptr writeonly %arg.raw.4, i64 %arg.raw.5.0, i64 %arg.raw.6.0, ptr readnone %arg.raw32.0, ptr readnone %arg.raw32.1, i64 %arg.raw32.2, i64 %arg.raw32.3, ptr writeonly %arg.raw32.4, i64 %arg.raw32.5.0, i64 %arg.raw32.6.0, ptr readnone %arg.index.0, ptr readnone %arg.index.1, i64 %arg.index.2, i64 %arg.index.3, ptr readonly %arg.index.4, i64 %arg.index.5.0, i64 %arg.index.6.0) {
B0.endif:
  %.104 = icmp slt i64 %arg.m, 0
  %.105 = select i1 %.104, i64 %arg.blocks.5.0, i64 0
  %.106 = add i64 %.105, %arg.m
  %.126 = mul i64 %.106, %arg.blocks.5.1
  %0 = getelementptr i64, ptr %arg.blocks.4, i64 %.126
  %.130 = getelementptr i8, ptr %0, i64 48
  %.131 = load i64, ptr %.130, align 8
  %.185 = getelementptr i8, ptr %0, i64 40
  %.186 = load i64, ptr %.185, align 8
  %.240 = getelementptr i8, ptr %0, i64 64
  %.241 = load i64, ptr %.240, align 8
  %.370 = getelementptr i8, ptr %0, i64 32
  %.371 = load i64, ptr %.370, align 8
  %.454569.not = icmp slt i64 %.371, 1
  br i1 %.454569.not, label %common.ret, label %B190.lr.ph
B190.lr.ph:                                       ; preds = %B0.endif
  %sunkaddr = shl i64 %.126, 3
  %sunkaddr303 = getelementptr i8, ptr %arg.blocks.4, i64 %sunkaddr
  %sunkaddr304 = getelementptr i8, ptr %sunkaddr303, i64 56
  %.296 = load i64, ptr %sunkaddr304, align 8
  switch i64 %.296, label %B190.preheader [
    i64 0, label %B190.lr.ph.split.us
    i64 3, label %B190.us581.preheader
    i64 4, label %B190.us596.preheader
    i64 5, label %B190.us611.preheader
  ]
B190.us611.preheader:                             ; preds = %B190.lr.ph
  %const = bitcast i64 9223372036854775806 to i64
  %.80.i = getelementptr i8, ptr %arg.index.4, i64 8
  %1 = and i64 %.241, -2
  %2 = add i64 %arg.raw.5.0, 1
  %3 = and i64 %.241, %const
  %.141.epil.i100 = shl nsw i64 %3, 3
  %.989.us = add i64 %3, %.131
  %scevgep61 = getelementptr i8, ptr %arg.raw.4, i64 %.131
  %4 = lshr i64 %.241, 1
  %5 = mul i64 %4, -2
  br label %B190.us611
B190.us596.preheader:                             ; preds = %B190.lr.ph
  %.10362.not.i38 = icmp slt i64 %.241, 1
  %6 = add i64 %arg.raw.5.0, 1
  br i1 %.10362.not.i38, label %common.ret, label %B190.us596.preheader195
B190.us596.preheader195:                          ; preds = %B190.us596.preheader
  %const82 = bitcast i64 9223372036854775806 to i64
  %7 = and i64 %.241, %const82
  %.141.epil.i65 = shl nsw i64 %7, 3
  %.916.us = add i64 %7, %.131
  br label %B190.us596
B190.us581.preheader:                             ; preds = %B190.lr.ph
  %.10362.not.i = icmp slt i64 %.241, 1
  %8 = add i64 %arg.raw.5.0, 1
  br i1 %.10362.not.i, label %common.ret, label %B190.us581.preheader192
B190.us581.preheader192:                          ; preds = %B190.us581.preheader
  %const83 = bitcast i64 9223372036854775806 to i64
  %9 = and i64 %.241, %const83
  %.141.epil.i = shl nsw i64 %9, 3
  %.782.us = add i64 %9, %.131
  br label %B190.us581
B190.preheader:                                   ; preds = %B190.lr.ph
  %.10362.not.i144 = icmp slt i64 %.241, 1
  %10 = add i64 %arg.raw.5.0, 1
  br i1 %.10362.not.i144, label %common.ret, label %B190.preheader187
B190.preheader187:                                ; preds = %B190.preheader
  %const84 = bitcast i64 9223372036854775806 to i64
  %11 = and i64 %.241, %const84
  %.141.epil.i171 = shl nsw i64 %11, 3
  %.1269 = add i64 %11, %.131
  br label %B190
B190.lr.ph.split.us:                              ; preds = %B190.lr.ph
  %.499 = icmp eq i64 %.241, 8
  br i1 %.499, label %B190.us.us.preheader, label %B190.us.preheader
B190.us.preheader:                                ; preds = %B190.lr.ph.split.us
  %.706.1 = ashr i64 %.131, 2
  %12 = shl i64 %arg.z.5.0, 3
  %13 = shl i64 %arg.raw32.5.0, 2
  br label %B190.us
B190.us.us.preheader:                             ; preds = %B190.lr.ph.split.us
  %14 = add i64 %arg.raw.5.0, 1
  %scevgep227 = getelementptr i8, ptr %arg.raw.4, i64 %.131
  %15 = shl i64 %.186, 3
  %scevgep244 = getelementptr i8, ptr %arg.whole.4, i64 %15
  %16 = shl i64 %arg.whole.5.0, 3
  %17 = add i64 %arg.raw.5.0, 2
  %18 = add i64 %arg.raw.5.0, 3
  %19 = add i64 %arg.raw.5.0, 4
  %20 = add i64 %arg.raw.5.0, 5
  %21 = add i64 %arg.raw.5.0, 6
  %22 = add i64 %arg.raw.5.0, 7
  br label %B190.us.us
B190.us.us:                                       ; preds = %B190.us.us, %B190.us.us.preheader
  %lsr.iv249 = phi i64 [ %.371, %B190.us.us.preheader ], [ %lsr.iv.next250, %B190.us.us ]
  %lsr.iv247 = phi i64 [ %.186, %B190.us.us.preheader ], [ %lsr.iv.next248, %B190.us.us ]
  %lsr.iv225 = phi i64 [ 0, %B190.us.us.preheader ], [ %lsr.iv.next226, %B190.us.us ]
  %23 = add i64 %.131, %lsr.iv225
  %.524.us.us = icmp slt i64 %lsr.iv247, 0
  %24 = select i1 %.524.us.us, i64 %16, i64 0
  %scevgep245 = getelementptr i8, ptr %scevgep244, i64 %24
  %scevgep246 = getelementptr i8, ptr %scevgep245, i64 %lsr.iv225
  %.540.us.us = load i64, ptr %scevgep246, align 8
  %25 = add i64 %.131, %lsr.iv225
  %26 = add i64 %25, 1
  %.160.i = icmp slt i64 %23, 0
  %.161.i = select i1 %.160.i, i64 %arg.raw.5.0, i64 0
  %scevgep236 = getelementptr i8, ptr %scevgep227, i64 %.161.i
  %scevgep237 = getelementptr i8, ptr %scevgep236, i64 %lsr.iv225
  %.176.i = trunc i64 %.540.us.us to i8
  store i8 %.176.i, ptr %scevgep237, align 1
  %.143.1.i = lshr i64 %.540.us.us, 8
  %.160.1.i = icmp slt i64 %26, 0
  %27 = select i1 %.160.1.i, i64 %14, i64 1
  %scevgep238 = getelementptr i8, ptr %scevgep227, i64 %27
  %scevgep239 = getelementptr i8, ptr %scevgep238, i64 %lsr.iv225
  %.176.1.i = trunc i64 %.143.1.i to i8
  store i8 %.176.1.i, ptr %scevgep239, align 1
  %28 = add i64 %.131, %lsr.iv225
  %29 = add i64 %28, 3
  %.143.i.1 = lshr i64 %.540.us.us, 16
  %30 = add i64 %.131, %lsr.iv225
  %31 = add i64 %30, 2
  %.160.i.1 = icmp slt i64 %31, 0
  %32 = select i1 %.160.i.1, i64 %17, i64 2
  %scevgep242 = getelementptr i8, ptr %scevgep227, i64 %32
  %scevgep243 = getelementptr i8, ptr %scevgep242, i64 %lsr.iv225
  %.176.i.1 = trunc i64 %.143.i.1 to i8
  store i8 %.176.i.1, ptr %scevgep243, align 1
  %.143.1.i.1 = lshr i64 %.540.us.us, 24
  %.160.1.i.1 = icmp slt i64 %29, 0
  %33 = select i1 %.160.1.i.1, i64 %18, i64 3
  %scevgep240 = getelementptr i8, ptr %scevgep227, i64 %33
  %scevgep241 = getelementptr i8, ptr %scevgep240, i64 %lsr.iv225
  %.176.1.i.1 = trunc i64 %.143.1.i.1 to i8
  store i8 %.176.1.i.1, ptr %scevgep241, align 1
  %34 = add i64 %.131, %lsr.iv225
  %35 = add i64 %34, 5
  %.143.i.2 = lshr i64 %.540.us.us, 32
  %36 = add i64 %.131, %lsr.iv225
  %37 = add i64 %36, 4
  %.160.i.2 = icmp slt i64 %37, 0
  %38 = select i1 %.160.i.2, i64 %19, i64 4
  %scevgep232 = getelementptr i8, ptr %scevgep227, i64 %38
  %scevgep233 = getelementptr i8, ptr %scevgep232, i64 %lsr.iv225
  %.176.i.2 = trunc i64 %.143.i.2 to i8
  store i8 %.176.i.2, ptr %scevgep233, align 1
  %.143.1.i.2 = lshr i64 %.540.us.us, 40
  %.160.1.i.2 = icmp slt i64 %35, 0
  %39 = select i1 %.160.1.i.2, i64 %20, i64 5
  %scevgep234 = getelementptr i8, ptr %scevgep227, i64 %39
  %scevgep235 = getelementptr i8, ptr %scevgep234, i64 %lsr.iv225
  %.176.1.i.2 = trunc i64 %.143.1.i.2 to i8
  store i8 %.176.1.i.2, ptr %scevgep235, align 1
  %40 = add i64 %.131, %lsr.iv225
  %41 = add i64 %40, 7
  %.143.i.3 = lshr i64 %.540.us.us, 48
  %42 = add i64 %.131, %lsr.iv225
  %43 = add i64 %42, 6
  %.160.i.3 = icmp slt i64 %43, 0
  %44 = select i1 %.160.i.3, i64 %21, i64 6
  %scevgep228 = getelementptr i8, ptr %scevgep227, i64 %44
  %scevgep229 = getelementptr i8, ptr %scevgep228, i64 %lsr.iv225
  %.176.i.3 = trunc i64 %.143.i.3 to i8
  store i8 %.176.i.3, ptr %scevgep229, align 1
  %.541.us.us = lshr i64 %.540.us.us, 56
  %.160.1.i.3 = icmp slt i64 %41, 0
  %45 = select i1 %.160.1.i.3, i64 %22, i64 7
  %scevgep230 = getelementptr i8, ptr %scevgep227, i64 %45
  %scevgep231 = getelementptr i8, ptr %scevgep230, i64 %lsr.iv225
  %46 = trunc i64 %.541.us.us to i8
  %.176.1.i.3 = xor i8 %46, -128
  store i8 %.176.1.i.3, ptr %scevgep231, align 1
  %lsr.iv.next226 = add nuw i64 %lsr.iv225, 8
  %lsr.iv.next248 = add i64 %lsr.iv247, 1
  %lsr.iv.next250 = add i64 %lsr.iv249, -1
  %exitcond654.not = icmp eq i64 %lsr.iv.next250, 0
  br i1 %exitcond654.not, label %common.ret, label %B190.us.us
B190.us:                                          ; preds = %B438.else.if.us, %B190.us.preheader
  %lsr.iv259 = phi i64 [ %lsr.iv.next260, %B438.else.if.us ], [ %.371, %B190.us.preheader ]
  %lsr.iv255 = phi i64 [ %lsr.iv.next256, %B438.else.if.us ], [ %.186, %B190.us.preheader ]
  %lsr.iv252 = phi i64 [ %lsr.iv.next253, %B438.else.if.us ], [ %.706.1, %B190.us.preheader ]
  %.590.us = icmp slt i64 %lsr.iv255, 0
  %47 = select i1 %.590.us, i64 %12, i64 0
  %scevgep257 = getelementptr i8, ptr %arg.z.4, i64 %47
  %48 = shl i64 %lsr.iv255, 3
  %scevgep258 = getelementptr i8, ptr %scevgep257, i64 %48
  %.606.us = load double, ptr %scevgep258, align 8
  %.607.us = tail call double @llvm.fabs.f64(double %.606.us)
  %.608.us = fcmp ogt double %.607.us, 0x47EFFFFFEFFFFFFF
  br i1 %.608.us, label %common.ret, label %B438.else.if.us
B438.else.if.us:                                  ; preds = %B190.us
  %.756.us = icmp slt i64 %lsr.iv252, 0
  %49 = select i1 %.756.us, i64 %13, i64 0
  %scevgep251 = getelementptr i8, ptr %arg.raw32.4, i64 %49
  %50 = shl i64 %lsr.iv252, 2
  %scevgep254 = getelementptr i8, ptr %scevgep251, i64 %50
  %.772.us = fptrunc double %.606.us to float
  store float %.772.us, ptr %scevgep254, align 4
  %lsr.iv.next253 = add i64 %lsr.iv252, 1
  %lsr.iv.next256 = add i64 %lsr.iv255, 1
  %lsr.iv.next260 = add i64 %lsr.iv259, -1
  %exitcond653.not = icmp eq i64 %lsr.iv.next260, 0
  br i1 %exitcond653.not, label %common.ret, label %B190.us
B190.us581:                                       ; preds = %B1065.us586, %B190.us581.preheader192
  %lsr.iv264 = phi i64 [ %lsr.iv.next265, %B1065.us586 ], [ %.131, %B190.us581.preheader192 ]
  %.460561570.us583 = phi i64 [ %.467.us585, %B1065.us586 ], [ 0, %B190.us581.preheader192 ]
  %51 = icmp eq i64 %.241, 1
  %.780.us = mul nuw nsw i64 %.460561570.us583, %.241
  %sunkaddr86 = getelementptr i8, ptr %arg.index.4, i64 16
  %.812.us = load i64, ptr %sunkaddr86, align 8
  %.815.us = add nsw i64 %.460561570.us583, %.186
  %.831.us = icmp slt i64 %.815.us, 0
  %.832.us = select i1 %.831.us, i64 %arg.whole.5.0, i64 0
  %52 = getelementptr i64, ptr %arg.whole.4, i64 %.815.us
  %.846.us = getelementptr i64, ptr %52, i64 %.832.us
  %.847.us = load i64, ptr %.846.us, align 8
  %.862.us = icmp slt i64 %.847.us, -3
  %.863.us = select i1 %.862.us, i64 %arg.index.5.0, i64 0
  %53 = getelementptr i64, ptr %arg.index.4, i64 %.847.us
  %54 = getelementptr i8, ptr %53, i64 24
  %.877.us = getelementptr i64, ptr %54, i64 %.863.us
  %.878.us = load i64, ptr %.877.us, align 8
  %.879.us = add nsw i64 %.878.us, %.812.us
  br i1 %51, label %B36.epil.preheader.i, label %B36.i18.preheader
B36.i18.preheader:                                ; preds = %B190.us581
  br label %B36.i18
B36.i18:                                          ; preds = %B36.i18.preheader, %B36.i18
  %lsr.iv52 = phi i64 [ %lsr.iv264, %B36.i18.preheader ], [ %lsr.iv.next53, %B36.i18 ]
  %lsr.iv49 = phi i64 [ %9, %B36.i18.preheader ], [ %lsr.iv.next50, %B36.i18 ]
  %lsr.iv.i22 = phi i64 [ %lsr.iv.next.i32, %B36.i18 ], [ 8, %B36.i18.preheader ]
  %55 = add i64 %lsr.iv.i22, -8
  %.143.i23 = ashr i64 %.879.us, %55
  %.160.i24 = icmp slt i64 %lsr.iv52, 0
  %.161.i25 = select i1 %.160.i24, i64 %arg.raw.5.0, i64 0
  %scevgep60 = getelementptr i8, ptr %arg.raw.4, i64 %.161.i25
  %scevgep62 = getelementptr i8, ptr %scevgep60, i64 %lsr.iv52
  %.176.i27 = trunc i64 %.143.i23 to i8
  store i8 %.176.i27, ptr %scevgep62, align 1
  %.143.1.i28 = ashr i64 %.879.us, %lsr.iv.i22
  %56 = add i64 %lsr.iv52, 1
  %.160.1.i29 = icmp slt i64 %56, 0
  %57 = select i1 %.160.1.i29, i64 %8, i64 1
  %scevgep55 = getelementptr i8, ptr %arg.raw.4, i64 %57
  %scevgep59 = getelementptr i8, ptr %scevgep55, i64 %lsr.iv52
  %.176.1.i31 = trunc i64 %.143.1.i28 to i8
  store i8 %.176.1.i31, ptr %scevgep59, align 1
  %lsr.iv.next.i32 = add i64 %lsr.iv.i22, 16
  %lsr.iv.next50 = add i64 %lsr.iv49, -2
  %lsr.iv.next53 = add i64 %lsr.iv52, 2
  %niter.ncmp.1.i36 = icmp eq i64 %lsr.iv.next50, 0
  br i1 %niter.ncmp.1.i36, label %B74.loopexit.unr-lcssa.i, label %B36.i18
B74.loopexit.unr-lcssa.i:                         ; preds = %B36.i18
  %58 = and i64 %.241, 1
  %59 = icmp eq i64 %58, 0
  br i1 %59, label %B1065.us586, label %B36.epil.preheader.i
B36.epil.preheader.i:                             ; preds = %B74.loopexit.unr-lcssa.i, %B190.us581
  %.143.epil.i = ashr i64 %.879.us, %.141.epil.i
  %.146.epil.i = add i64 %.782.us, %.780.us
  %.160.epil.i = icmp slt i64 %.146.epil.i, 0
  %.161.epil.i = select i1 %.160.epil.i, i64 %arg.raw.5.0, i64 0
  %60 = getelementptr i8, ptr %arg.raw.4, i64 %.146.epil.i
  %.175.epil.i = getelementptr i8, ptr %60, i64 %.161.epil.i
  %.176.epil.i = trunc i64 %.143.epil.i to i8
  store i8 %.176.epil.i, ptr %.175.epil.i, align 1
  br label %B1065.us586
B1065.us586:                                      ; preds = %B36.epil.preheader.i, %B74.loopexit.unr-lcssa.i
  %.467.us585 = add nuw nsw i64 %.460561570.us583, 1
  %lsr.iv.next265 = add i64 %lsr.iv264, %.241
  %exitcond652.not = icmp eq i64 %.371, %.467.us585
  br i1 %exitcond652.not, label %common.ret, label %B190.us581
B190.us596:                                       ; preds = %B1065.us601, %B190.us596.preheader195
  %lsr.iv274 = phi i64 [ %lsr.iv.next275, %B1065.us601 ], [ %.131, %B190.us596.preheader195 ]
  %.460561570.us598 = phi i64 [ %.467.us600, %B1065.us601 ], [ 0, %B190.us596.preheader195 ]
  %61 = icmp eq i64 %.241, 1
  %.914.us = mul nuw nsw i64 %.460561570.us598, %.241
  %.919.us = add nsw i64 %.460561570.us598, %.186
  %.935.us = icmp slt i64 %.919.us, 0
  %.936.us = select i1 %.935.us, i64 %arg.whole.5.0, i64 0
  %62 = getelementptr i64, ptr %arg.whole.4, i64 %.919.us
  %.950.us = getelementptr i64, ptr %62, i64 %.936.us
  %.951.us = load i64, ptr %.950.us, align 8
  %.952.us = sub i64 0, %.951.us
  br i1 %61, label %B36.epil.preheader.i63, label %B36.i42.preheader
B36.i42.preheader:                                ; preds = %B190.us596
  br label %B36.i42
B36.i42:                                          ; preds = %B36.i42.preheader, %B36.i42
  %lsr.iv63 = phi i64 [ %lsr.iv274, %B36.i42.preheader ], [ %lsr.iv.next64, %B36.i42 ]
  %lsr.iv = phi i64 [ %7, %B36.i42.preheader ], [ %lsr.iv.next, %B36.i42 ]
  %lsr.iv.i46 = phi i64 [ %lsr.iv.next.i56, %B36.i42 ], [ 8, %B36.i42.preheader ]
  %63 = add i64 %lsr.iv.i46, -8
  %.143.i47 = ashr i64 %.952.us, %63
  %.160.i48 = icmp slt i64 %lsr.iv63, 0
  %.161.i49 = select i1 %.160.i48, i64 %arg.raw.5.0, i64 0
  %scevgep69 = getelementptr i8, ptr %arg.raw.4, i64 %.161.i49
  %scevgep70 = getelementptr i8, ptr %scevgep69, i64 %lsr.iv63
  %.176.i51 = trunc i64 %.143.i47 to i8
  store i8 %.176.i51, ptr %scevgep70, align 1
  %.143.1.i52 = ashr i64 %.952.us, %lsr.iv.i46
  %64 = add i64 %lsr.iv63, 1
  %.160.1.i53 = icmp slt i64 %64, 0
  %65 = select i1 %.160.1.i53, i64 %6, i64 1
  %scevgep = getelementptr i8, ptr %arg.raw.4, i64 %65
  %scevgep68 = getelementptr i8, ptr %scevgep, i64 %lsr.iv63
  %.176.1.i55 = trunc i64 %.143.1.i52 to i8
  store i8 %.176.1.i55, ptr %scevgep68, align 1
  %lsr.iv.next.i56 = add i64 %lsr.iv.i46, 16
  %lsr.iv.next = add i64 %lsr.iv, -2
  %lsr.iv.next64 = add i64 %lsr.iv63, 2
  %niter.ncmp.1.i60 = icmp eq i64 %lsr.iv.next, 0
  br i1 %niter.ncmp.1.i60, label %B74.loopexit.unr-lcssa.i61, label %B36.i42
B74.loopexit.unr-lcssa.i61:                       ; preds = %B36.i42
  %66 = and i64 %.241, 1
  %67 = icmp eq i64 %66, 0
  br i1 %67, label %B1065.us601, label %B36.epil.preheader.i63
B36.epil.preheader.i63:                           ; preds = %B74.loopexit.unr-lcssa.i61, %B190.us596
  %.143.epil.i66 = ashr i64 %.952.us, %.141.epil.i65
  %.146.epil.i67 = add i64 %.916.us, %.914.us
  %.160.epil.i68 = icmp slt i64 %.146.epil.i67, 0
  %.161.epil.i69 = select i1 %.160.epil.i68, i64 %arg.raw.5.0, i64 0
  %68 = getelementptr i8, ptr %arg.raw.4, i64 %.146.epil.i67
  %.175.epil.i70 = getelementptr i8, ptr %68, i64 %.161.epil.i69
  %.176.epil.i71 = trunc i64 %.143.epil.i66 to i8
  store i8 %.176.epil.i71, ptr %.175.epil.i70, align 1
  br label %B1065.us601
B1065.us601:                                      ; preds = %B36.epil.preheader.i63, %B74.loopexit.unr-lcssa.i61
  %.467.us600 = add nuw nsw i64 %.460561570.us598, 1
  %lsr.iv.next275 = add i64 %lsr.iv274, %.241
  %exitcond651.not = icmp eq i64 %.371, %.467.us600
  br i1 %exitcond651.not, label %common.ret, label %B190.us596
B190.us611:                                       ; preds = %B1065.us616, %B190.us611.preheader
  %lsr.iv284 = phi i64 [ %lsr.iv.next285, %B1065.us616 ], [ %.131, %B190.us611.preheader ]
  %.460561570.us613 = phi i64 [ %.467.us615, %B1065.us616 ], [ 0, %B190.us611.preheader ]
  %69 = icmp slt i64 %.241, 1
  %.467.us615 = add nuw nsw i64 %.460561570.us613, 1
  %.987.us = mul nsw i64 %.460561570.us613, %.241
  %sunkaddr87 = getelementptr i8, ptr %arg.index.4, i64 16
  %.1019.us = load i64, ptr %sunkaddr87, align 8
  %.1022.us = add nsw i64 %.460561570.us613, %.186
  %.1036.us = icmp slt i64 %.1022.us, 0
  %.1037.us = select i1 %.1036.us, i64 %arg.whole.5.0, i64 0
  %70 = getelementptr i64, ptr %arg.whole.4, i64 %.1022.us
  %.1051.us = getelementptr i64, ptr %70, i64 %.1037.us
  %.1052.us = load i64, ptr %.1051.us, align 8
  %.1067.us = icmp slt i64 %.1052.us, -3
  %.1068.us = select i1 %.1067.us, i64 %arg.index.5.0, i64 0
  %71 = getelementptr i64, ptr %arg.index.4, i64 %.1052.us
  %72 = getelementptr i8, ptr %71, i64 24
  %.1082.us = getelementptr i64, ptr %72, i64 %.1068.us
  %.1083.us = load i64, ptr %.1082.us, align 8
  %.1084.us = add nsw i64 %.1083.us, %.1019.us
  br i1 %69, label %B742.endif.endif.us, label %B36.preheader.i74
B36.preheader.i74:                                ; preds = %B190.us611
  %73 = icmp eq i64 %.241, 1
  br i1 %73, label %B36.epil.preheader.i98, label %B36.i77.preheader
B36.i77.preheader:                                ; preds = %B36.preheader.i74
  br label %B36.i77
B36.i77:                                          ; preds = %B36.i77.preheader, %B36.i77
  %lsr.iv73 = phi i64 [ %lsr.iv284, %B36.i77.preheader ], [ %lsr.iv.next74, %B36.i77 ]
  %lsr.iv71 = phi i64 [ %1, %B36.i77.preheader ], [ %lsr.iv.next72, %B36.i77 ]
  %lsr.iv.i81 = phi i64 [ %lsr.iv.next.i91, %B36.i77 ], [ 8, %B36.i77.preheader ]
  %74 = add i64 %lsr.iv.i81, -8
  %.143.i82 = ashr i64 %.1084.us, %74
  %.160.i83 = icmp slt i64 %lsr.iv73, 0
  %.161.i84 = select i1 %.160.i83, i64 %arg.raw.5.0, i64 0
  %scevgep78 = getelementptr i8, ptr %arg.raw.4, i64 %.161.i84
  %scevgep79 = getelementptr i8, ptr %scevgep78, i64 %lsr.iv73
  %.176.i86 = trunc i64 %.143.i82 to i8
  store i8 %.176.i86, ptr %scevgep79, align 1
  %.143.1.i87 = ashr i64 %.1084.us, %lsr.iv.i81
  %75 = add i64 %lsr.iv73, 1
  %.160.1.i88 = icmp slt i64 %75, 0
  %76 = select i1 %.160.1.i88, i64 %2, i64 1
  %scevgep76 = getelementptr i8, ptr %arg.raw.4, i64 %76
  %scevgep77 = getelementptr i8, ptr %scevgep76, i64 %lsr.iv73
  %.176.1.i90 = trunc i64 %.143.1.i87 to i8
  store i8 %.176.1.i90, ptr %scevgep77, align 1
  %lsr.iv.next.i91 = add i64 %lsr.iv.i81, 16
  %lsr.iv.next72 = add i64 %lsr.iv71, -2
  %lsr.iv.next74 = add i64 %lsr.iv73, 2
  %niter.ncmp.1.i95 = icmp eq i64 %lsr.iv.next72, 0
  br i1 %niter.ncmp.1.i95, label %B74.loopexit.unr-lcssa.i96, label %B36.i77
B74.loopexit.unr-lcssa.i96:                       ; preds = %B36.i77
  %77 = and i64 %.241, 1
  %78 = icmp eq i64 %77, 0
  br i1 %78, label %B742.endif.endif.us, label %B36.epil.preheader.i98
B36.epil.preheader.i98:                           ; preds = %B74.loopexit.unr-lcssa.i96, %B36.preheader.i74
  %.143.epil.i101 = ashr i64 %.1084.us, %.141.epil.i100
  %.146.epil.i102 = add i64 %.989.us, %.987.us
  %.160.epil.i103 = icmp slt i64 %.146.epil.i102, 0
  %.161.epil.i104 = select i1 %.160.epil.i103, i64 %arg.raw.5.0, i64 0
  %79 = getelementptr i8, ptr %arg.raw.4, i64 %.146.epil.i102
  %.175.epil.i105 = getelementptr i8, ptr %79, i64 %.161.epil.i104
  %.176.epil.i106 = trunc i64 %.143.epil.i101 to i8
  store i8 %.176.epil.i106, ptr %.175.epil.i105, align 1
  br label %B742.endif.endif.us
B742.endif.endif.us:                              ; preds = %B36.epil.preheader.i98, %B74.loopexit.unr-lcssa.i96, %B190.us611
  %80 = icmp slt i64 %.241, 1
  %sunkaddr88 = mul i64 %.126, 8
  %sunkaddr89 = getelementptr i8, ptr %arg.blocks.4, i64 %sunkaddr88
  %sunkaddr90 = getelementptr i8, ptr %sunkaddr89, i64 32
  %.1167.us = load i64, ptr %sunkaddr90, align 8
  %sunkaddr310 = shl i64 %.1037.us, 3
  %sunkaddr311 = getelementptr inbounds i8, ptr %70, i64 %sunkaddr310
  %.1208.us = load i64, ptr %sunkaddr311, align 8
  %.19.i = add nsw i64 %.1208.us, 1
  %.49.i = load i64, ptr %arg.index.4, align 8
  %.50.i = icmp eq i64 %.19.i, %.49.i
  %.102.i = icmp slt i64 %.1208.us, -4
  %.103.i = select i1 %.102.i, i64 %arg.index.5.0, i64 0
  %81 = getelementptr i64, ptr %arg.index.4, i64 %.1208.us
  %82 = getelementptr i8, ptr %81, i64 32
  %.117.i = getelementptr i64, ptr %82, i64 %.103.i
  %"$phi106.0.2.0.in.i" = select i1 %.50.i, ptr %.80.i, ptr %.117.i
  %"$phi106.0.2.0.i" = load i64, ptr %"$phi106.0.2.0.in.i", align 8
  %.142.i = icmp slt i64 %.1208.us, -3
  %.143.i108 = select i1 %.142.i, i64 %arg.index.5.0, i64 0
  %83 = getelementptr i8, ptr %81, i64 24
  %.157.i = getelementptr i64, ptr %83, i64 %.143.i108
  %.158.i = load i64, ptr %.157.i, align 8
  %84 = xor i64 %.158.i, -1
  %.162.i = add i64 %"$phi106.0.2.0.i", %84
  %.1169.us = add i64 %.1167.us, %.460561570.us613
  %.1171.us = mul i64 %.1169.us, %.241
  %.1173.us = add i64 %.1171.us, %.131
  br i1 %80, label %B1065.us616, label %B36.preheader.i110
B36.preheader.i110:                               ; preds = %B742.endif.endif.us
  %85 = icmp eq i64 %.241, 1
  br i1 %85, label %B36.epil.preheader.i134, label %B36.i113.preheader
B36.i113.preheader:                               ; preds = %B36.preheader.i110
  %scevgep71 = getelementptr i8, ptr %scevgep61, i64 %.1171.us
  br label %B36.i113
B36.i113:                                         ; preds = %B36.i113, %B36.i113.preheader
  %lsr.iv80 = phi i64 [ %lsr.iv.next81, %B36.i113 ], [ %5, %B36.i113.preheader ]
  %lsr.iv72 = phi ptr [ %scevgep71, %B36.i113.preheader ], [ %scevgep73, %B36.i113 ]
  %lsr.iv294 = phi i64 [ %.1173.us, %B36.i113.preheader ], [ %89, %B36.i113 ]
  %lsr.iv.i117 = phi i64 [ 8, %B36.i113.preheader ], [ %lsr.iv.next.i127, %B36.i113 ]
  %86 = add i64 %lsr.iv.i117, -8
  %.143.i118 = ashr i64 %.162.i, %86
  %.160.i119 = icmp slt i64 %lsr.iv294, 0
  %.161.i120 = select i1 %.160.i119, i64 %arg.raw.5.0, i64 0
  %scevgep75 = getelementptr i8, ptr %lsr.iv72, i64 %.161.i120
  %.176.i122 = trunc i64 %.143.i118 to i8
  store i8 %.176.i122, ptr %scevgep75, align 1
  %.143.1.i123 = ashr i64 %.162.i, %lsr.iv.i117
  %87 = add i64 %lsr.iv294, 1
  %.160.1.i124 = icmp slt i64 %87, 0
  %88 = select i1 %.160.1.i124, i64 %2, i64 1
  %scevgep74 = getelementptr i8, ptr %lsr.iv72, i64 %88
  %.176.1.i126 = trunc i64 %.143.1.i123 to i8
  store i8 %.176.1.i126, ptr %scevgep74, align 1
  %lsr.iv.next.i127 = add i64 %lsr.iv.i117, 16
  %scevgep73 = getelementptr i8, ptr %lsr.iv72, i64 2
  %lsr.iv.next81 = add i64 %lsr.iv80, 2
  %niter.ncmp.1.i131 = icmp eq i64 %lsr.iv.next81, 0
  %89 = add i64 %87, 1
  br i1 %niter.ncmp.1.i131, label %B74.loopexit.unr-lcssa.i132, label %B36.i113
B74.loopexit.unr-lcssa.i132:                      ; preds = %B36.i113
  %90 = and i64 %.241, 1
  %91 = icmp eq i64 %90, 0
  br i1 %91, label %B1065.us616, label %B36.epil.preheader.i134
B36.epil.preheader.i134:                          ; preds = %B74.loopexit.unr-lcssa.i132, %B36.preheader.i110
  %.143.epil.i137 = ashr i64 %.162.i, %.141.epil.i100
  %.146.epil.i138 = add nsw i64 %.1173.us, %3
  %.160.epil.i139 = icmp slt i64 %.146.epil.i138, 0
  %.161.epil.i140 = select i1 %.160.epil.i139, i64 %arg.raw.5.0, i64 0
  %92 = getelementptr i8, ptr %arg.raw.4, i64 %.146.epil.i138
  %.175.epil.i141 = getelementptr i8, ptr %92, i64 %.161.epil.i140
  %.176.epil.i142 = trunc i64 %.143.epil.i137 to i8
  store i8 %.176.epil.i142, ptr %.175.epil.i141, align 1
  br label %B1065.us616
B1065.us616:                                      ; preds = %B36.epil.preheader.i134, %B74.loopexit.unr-lcssa.i132, %B742.endif.endif.us
  %lsr.iv.next285 = add i64 %lsr.iv284, %.241
  %exitcond.not = icmp eq i64 %.371, %.467.us615
  br i1 %exitcond.not, label %common.ret, label %B190.us611
B190:                                             ; preds = %B1065, %B190.preheader187
  %lsr.iv218 = phi i64 [ %lsr.iv.next219, %B1065 ], [ %.131, %B190.preheader187 ]
  %.460561570 = phi i64 [ %.467, %B1065 ], [ 0, %B190.preheader187 ]
  %93 = icmp eq i64 %.241, 1
  %.1267 = mul nuw nsw i64 %.460561570, %.241
  %.1272 = add nsw i64 %.460561570, %.186
  %.1288 = icmp slt i64 %.1272, 0
  %.1289 = select i1 %.1288, i64 %arg.whole.5.0, i64 0
  %94 = getelementptr i64, ptr %arg.whole.4, i64 %.1272
  %.1303 = getelementptr i64, ptr %94, i64 %.1289
  %.1304 = load i64, ptr %.1303, align 8
  br i1 %93, label %B36.epil.preheader.i169, label %B36.i148.preheader
B36.i148.preheader:                               ; preds = %B190
  br label %B36.i148
B36.i148:                                         ; preds = %B36.i148.preheader, %B36.i148
  %lsr.iv38 = phi i64 [ %lsr.iv218, %B36.i148.preheader ], [ %lsr.iv.next39, %B36.i148 ]
  %lsr.iv36 = phi i64 [ %11, %B36.i148.preheader ], [ %lsr.iv.next37, %B36.i148 ]
  %lsr.iv.i152 = phi i64 [ %lsr.iv.next.i162, %B36.i148 ], [ 8, %B36.i148.preheader ]
  %95 = add i64 %lsr.iv.i152, -8
  %.143.i153 = ashr i64 %.1304, %95
  %.160.i154 = icmp slt i64 %lsr.iv38, 0
  %.161.i155 = select i1 %.160.i154, i64 %arg.raw.5.0, i64 0
  %scevgep45 = getelementptr i8, ptr %arg.raw.4, i64 %.161.i155
  %scevgep47 = getelementptr i8, ptr %scevgep45, i64 %lsr.iv38
  %.176.i157 = trunc i64 %.143.i153 to i8
  store i8 %.176.i157, ptr %scevgep47, align 1
  %.143.1.i158 = ashr i64 %.1304, %lsr.iv.i152
  %96 = add i64 %lsr.iv38, 1
  %.160.1.i159 = icmp slt i64 %96, 0
  %97 = select i1 %.160.1.i159, i64 %10, i64 1
  %scevgep43 = getelementptr i8, ptr %arg.raw.4, i64 %97
  %scevgep44 = getelementptr i8, ptr %scevgep43, i64 %lsr.iv38
  %.176.1.i161 = trunc i64 %.143.1.i158 to i8
  store i8 %.176.1.i161, ptr %scevgep44, align 1
  %lsr.iv.next.i162 = add i64 %lsr.iv.i152, 16
  %lsr.iv.next37 = add i64 %lsr.iv36, -2
  %lsr.iv.next39 = add i64 %lsr.iv38, 2
  %niter.ncmp.1.i166 = icmp eq i64 %lsr.iv.next37, 0
  br i1 %niter.ncmp.1.i166, label %B74.loopexit.unr-lcssa.i167, label %B36.i148
B74.loopexit.unr-lcssa.i167:                      ; preds = %B36.i148
  %98 = and i64 %.241, 1
  %99 = icmp eq i64 %98, 0
  br i1 %99, label %B1065, label %B36.epil.preheader.i169
B36.epil.preheader.i169:                          ; preds = %B74.loopexit.unr-lcssa.i167, %B190
  %.143.epil.i172 = ashr i64 %.1304, %.141.epil.i171
  %.146.epil.i173 = add i64 %.1269, %.1267
  %.160.epil.i174 = icmp slt i64 %.146.epil.i173, 0
  %.161.epil.i175 = select i1 %.160.epil.i174, i64 %arg.raw.5.0, i64 0
  %100 = getelementptr i8, ptr %arg.raw.4, i64 %.146.epil.i173
  %.175.epil.i176 = getelementptr i8, ptr %100, i64 %.161.epil.i175
  %.176.epil.i177 = trunc i64 %.143.epil.i172 to i8
  store i8 %.176.epil.i177, ptr %.175.epil.i176, align 1
  br label %B1065
common.ret:                                       ; preds = %B1065.us616, %B1065.us601, %B1065.us586, %B438.else.if.us, %B190.us, %B190.us.us, %B1065, %B190.preheader, %B190.us581.preheader, %B190.us596.preheader, %B0.endif
  %storemerge = phi i64 [ -1, %B0.endif ], [ -1, %B1065 ], [ -1, %B1065.us586 ], [ -1, %B190.preheader ], [ %lsr.iv255, %B190.us ], [ -1, %B190.us.us ], [ -1, %B190.us581.preheader ], [ -1, %B1065.us601 ], [ -1, %B190.us596.preheader ], [ -1, %B438.else.if.us ], [ -1, %B1065.us616 ]
  store i64 %storemerge, ptr %retptr, align 8
  ret i32 0
B1065:                                            ; preds = %B36.epil.preheader.i169, %B74.loopexit.unr-lcssa.i167
  %.467 = add nuw nsw i64 %.460561570, 1
  %lsr.iv.next219 = add i64 %lsr.iv218, %.241
  %exitcond655.not = icmp eq i64 %.371, %.467
  br i1 %exitcond655.not, label %common.ret, label %B190
}
define linkonce_odr i32 @f71(ptr noalias writeonly %retptr, ptr noalias writeonly %excinfo, ptr readnone %arg.blocks.0, ptr readnone %arg.blocks.1, i64 %arg.blocks.2, i64 %arg.blocks.3, ptr readonly %arg.blocks.4, i64 %arg.blocks.5.0, i64 %arg.blocks.5.1, i64 %arg.blocks.6.0, i64 %arg.blocks.6.1, i64 %arg.m, ptr readnone %arg.z.0, ptr readnone %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr writeonly %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr readnone %arg.whole.0, ptr readnone %arg.whole.1, i64 %arg.whole.2, i64 %arg.whole.3, ptr writeonly %arg.whole.4, i64 %arg.whole.5.0, i64 %arg.whole.6.0, ptr readnone %arg.raw.0, ptr readnone %arg.raw.1, i64 %arg.raw.2, i64 %arg.raw.3, ptr readonly %arg.raw.4, i64 %arg.raw.5.0, i64 %arg.raw.6.0, ptr readnone %arg.raw32.0, ptr readnone %arg.raw32.1, i64 %arg.raw32.2, i64 %arg.raw32.3, ptr readonly %arg.raw32.4, i64 %arg.raw32.5.0, i64 %arg.raw32.6.0, ptr readnone %arg.pool.0, ptr readnone %arg.pool.1, i64 %arg.pool.2, i64 %arg.pool.3, ptr %arg.pool.4, i64 %arg.pool.5.0, i64 %arg.pool.6.0, ptr readnone %arg.index.0, ptr readnone %arg.index.1, i64 %arg.index.2, i64 %arg.index.3, ptr %arg.index.4, i64 %arg.index.5.0, i64 %arg.index.6.0) {
B0.endif:
  %.70.i = alloca i64, align 8
  %excinfo.2.i = alloca ptr, align 8
  %.1140 = alloca i64, align 8
  %excinfo.9 = alloca ptr, align 8
  %.115 = icmp slt i64 %arg.m, 0
  %.116 = select i1 %.115, i64 %arg.blocks.5.0, i64 0
  %.117 = add i64 %.116, %arg.m
  %.137 = mul i64 %.117, %arg.blocks.5.1
  %0 = getelementptr i64, ptr %arg.blocks.4, i64 %.137
  %.141 = getelementptr i8, ptr %0, i64 48
  %.142 = load i64, ptr %.141, align 8
  %.196 = getelementptr i8, ptr %0, i64 40
  %.197 = load i64, ptr %.196, align 8
  %.251 = getelementptr i8, ptr %0, i64 64
  %.252 = load i64, ptr %.251, align 8
  %.381 = getelementptr i8, ptr %0, i64 32
  %.382 = load i64, ptr %.381, align 8
  %.465691.not = icmp slt i64 %.382, 1
  br i1 %.465691.not, label %B1062, label %B190.lr.ph
B190.lr.ph:                                       ; preds = %B0.endif
  %sunkaddr = shl i64 %.137, 3
  %sunkaddr560 = getelementptr i8, ptr %arg.blocks.4, i64 %sunkaddr
  %sunkaddr561 = getelementptr i8, ptr %sunkaddr560, i64 56
  %.307 = load i64, ptr %sunkaddr561, align 8
  %.593.1 = ashr i64 %.142, 2
  switch i64 %.307, label %B190.preheader [
    i64 0, label %B190.lr.ph.split.us
    i64 3, label %B190.us700.preheader
    i64 2, label %B190.us721.preheader
    i64 4, label %B190.us736.preheader
    i64 5, label %B190.us751.preheader
  ]
B190.us751.preheader:                             ; preds = %B190.lr.ph
  %const = bitcast i64 9223372036854775806 to i64
  %1 = and i64 %.252, -2
  %2 = add i64 %arg.raw.5.0, 1
  %3 = and i64 %.252, %const
  %.180.epil.i187 = shl nsw i64 %3, 3
  %scevgep128 = getelementptr i8, ptr %arg.raw.4, i64 %.142
  %4 = lshr i64 %.252, 1
  %5 = mul i64 %4, -2
  br label %B190.us751
B190.us736.preheader:                             ; preds = %B190.lr.ph
  %const162 = bitcast i64 9223372036854775806 to i64
  %6 = and i64 %.252, -2
  %7 = add i64 %arg.raw.5.0, 1
  %8 = and i64 %.252, %const162
  %.251.i = shl nsw i64 %.252, 3
  %.254.neg.i = shl nsw i64 -1, %.251.i
  %.180.epil.i142 = shl nsw i64 %8, 3
  br label %B190.us736
B190.us721.preheader:                             ; preds = %B190.lr.ph
  %.109106.not.i58 = icmp slt i64 %.252, 1
  %9 = add i64 %arg.raw.5.0, 1
  br i1 %.109106.not.i58, label %B190.us721.us.preheader, label %B190.us721.preheader373
B190.us721.us.preheader:                          ; preds = %B190.us721.preheader
  %xtraiter = and i64 %.382, 3
  %10 = icmp ult i64 %.382, 4
  br i1 %10, label %B190.us721.us.preheader.B190.us721.us.epil.preheader_crit_edge, label %B190.us721.us.preheader.new
B190.us721.us.preheader.B190.us721.us.epil.preheader_crit_edge: ; preds = %B190.us721.us.preheader
  %.pre = shl i64 %arg.whole.5.0, 3
  br label %B190.us721.us.epil.preheader
B190.us721.us.preheader.new:                      ; preds = %B190.us721.us.preheader
  %const164 = bitcast i64 9223372036854775806 to i64
  %const_mat = add i64 %const164, -2
  %unroll_iter = and i64 %.382, %const_mat
  %11 = shl i64 %.197, 3
  %scevgep505 = getelementptr i8, ptr %arg.whole.4, i64 %11
  %12 = shl i64 %arg.whole.5.0, 3
  %13 = add i64 %12, 8
  %14 = add i64 %12, 16
  %15 = add i64 %12, 24
  br label %B190.us721.us
B190.us721.preheader373:                          ; preds = %B190.us721.preheader
  %const163 = bitcast i64 9223372036854775806 to i64
  %16 = and i64 %.252, %const163
  %.180.epil.i97 = shl nsw i64 %16, 3
  %.872.us = add i64 %16, %.142
  br label %B190.us721
B190.us721.us:                                    ; preds = %B190.us721.us, %B190.us721.us.preheader.new
  %.471680692.us723.us = phi i64 [ 0, %B190.us721.us.preheader.new ], [ %.478.us725.us.3, %B190.us721.us ]
  %17 = add i64 %.197, %.471680692.us723.us
  %.920.us.us = icmp slt i64 %17, 0
  %18 = select i1 %.920.us.us, i64 %12, i64 0
  %scevgep515 = getelementptr i8, ptr %scevgep505, i64 %18
  %19 = shl i64 %.471680692.us723.us, 3
  %scevgep516 = getelementptr i8, ptr %scevgep515, i64 %19
  store i64 0, ptr %scevgep516, align 8
  %20 = add i64 %.197, %.471680692.us723.us
  %21 = add i64 %20, 1
  %.920.us.us.1 = icmp slt i64 %21, 0
  %22 = select i1 %.920.us.us.1, i64 %13, i64 8
  %scevgep108 = getelementptr i8, ptr %scevgep505, i64 %22
  %23 = shl i64 %.471680692.us723.us, 3
  %scevgep134 = getelementptr i8, ptr %scevgep108, i64 %23
  store i64 0, ptr %scevgep134, align 8
  %24 = add i64 %.197, %.471680692.us723.us
  %25 = add i64 %24, 2
  %.920.us.us.2 = icmp slt i64 %25, 0
  %26 = select i1 %.920.us.us.2, i64 %14, i64 16
  %scevgep106 = getelementptr i8, ptr %scevgep505, i64 %26
  %27 = shl i64 %.471680692.us723.us, 3
  %scevgep130 = getelementptr i8, ptr %scevgep106, i64 %27
  store i64 0, ptr %scevgep130, align 8
  %.478.us725.us.3 = add nuw nsw i64 %.471680692.us723.us, 4
  %28 = add i64 %.197, %.471680692.us723.us
  %29 = add i64 %28, 3
  %.920.us.us.3 = icmp slt i64 %29, 0
  %30 = select i1 %.920.us.us.3, i64 %15, i64 24
  %scevgep104 = getelementptr i8, ptr %scevgep505, i64 %30
  %31 = shl i64 %.471680692.us723.us, 3
  %scevgep127 = getelementptr i8, ptr %scevgep104, i64 %31
  store i64 0, ptr %scevgep127, align 8
  %niter.ncmp.3 = icmp eq i64 %unroll_iter, %.478.us725.us.3
  br i1 %niter.ncmp.3, label %B1062.loopexit418.unr-lcssa, label %B190.us721.us
B190.us700.preheader:                             ; preds = %B190.lr.ph
  %const165 = bitcast i64 9223372036854775806 to i64
  %32 = and i64 %.252, -2
  %33 = add i64 %arg.raw.5.0, 1
  %34 = and i64 %.252, %const165
  %.180.epil.i = shl nsw i64 %34, 3
  %.702.us = add i64 %34, %.142
  br label %B190.us700
B190.preheader:                                   ; preds = %B190.lr.ph
  %const169 = bitcast i64 9223372036854775806 to i64
  %35 = and i64 %.252, -2
  %36 = add i64 %arg.raw.5.0, 1
  %37 = and i64 %.252, %const169
  %.251.i318 = shl nsw i64 %.252, 3
  %.254.neg.i319 = shl nsw i64 -1, %.251.i318
  %.180.epil.i303 = shl nsw i64 %37, 3
  br label %B190
B190.lr.ph.split.us:                              ; preds = %B190.lr.ph
  %.510 = icmp eq i64 %.252, 8
  br i1 %.510, label %B190.us.us.preheader, label %B190.us.preheader
B190.us.preheader:                                ; preds = %B190.lr.ph.split.us
  %38 = icmp eq i64 %.382, 1
  br i1 %38, label %B190.us.epil.preheader, label %B190.us.preheader.new
B190.us.preheader.new:                            ; preds = %B190.us.preheader
  %const166 = bitcast i64 9223372036854775806 to i64
  %unroll_iter430 = and i64 %.382, %const166
  %39 = and i64 %.142, -4
  %scevgep477 = getelementptr i8, ptr %arg.raw32.4, i64 %39
  %40 = shl i64 %.197, 3
  %scevgep481 = getelementptr i8, ptr %arg.z.4, i64 %40
  %41 = shl i64 %arg.raw32.5.0, 2
  %42 = shl i64 %arg.z.5.0, 3
  %43 = add i64 %41, 4
  %44 = add i64 %42, 8
  br label %B190.us
B190.us.us.preheader:                             ; preds = %B190.lr.ph.split.us
  %const167 = bitcast i64 9223372036854775806 to i64
  %45 = add i64 %arg.raw.5.0, 1
  %scevgep453 = getelementptr i8, ptr %arg.raw.4, i64 %.142
  %46 = shl i64 %.197, 3
  %scevgep470 = getelementptr i8, ptr %arg.whole.4, i64 %46
  %47 = add i64 %arg.raw.5.0, 2
  %48 = add i64 %arg.raw.5.0, 3
  %49 = add i64 %arg.raw.5.0, 4
  %50 = add i64 %arg.raw.5.0, 5
  %51 = add i64 %arg.raw.5.0, 6
  %52 = add i64 %arg.raw.5.0, 7
  %53 = shl i64 %arg.whole.5.0, 3
  br label %B190.us.us
B190.us.us:                                       ; preds = %B190.us.us, %B190.us.us.preheader
  %lsr.iv475 = phi i64 [ %.382, %B190.us.us.preheader ], [ %lsr.iv.next476, %B190.us.us ]
  %lsr.iv473 = phi i64 [ %.197, %B190.us.us.preheader ], [ %lsr.iv.next474, %B190.us.us ]
  %lsr.iv451 = phi i64 [ 0, %B190.us.us.preheader ], [ %lsr.iv.next452, %B190.us.us ]
  %54 = add i64 %.142, %lsr.iv451
  %55 = add i64 %54, 1
  %.162.i = icmp slt i64 %54, 0
  %.163.i = select i1 %.162.i, i64 %arg.raw.5.0, i64 0
  %scevgep462 = getelementptr i8, ptr %scevgep453, i64 %.163.i
  %scevgep463 = getelementptr i8, ptr %scevgep462, i64 %lsr.iv451
  %.178.i = load i8, ptr %scevgep463, align 1
  %.179.i = zext i8 %.178.i to i64
  %.162.1.i = icmp slt i64 %55, 0
  %56 = select i1 %.162.1.i, i64 %45, i64 1
  %scevgep464 = getelementptr i8, ptr %scevgep453, i64 %56
  %scevgep465 = getelementptr i8, ptr %scevgep464, i64 %lsr.iv451
  %.178.1.i = load i8, ptr %scevgep465, align 1
  %.179.1.i = zext i8 %.178.1.i to i64
  %.181.1.i = shl nuw nsw i64 %.179.1.i, 8
  %.183.1.i = or i64 %.181.1.i, %.179.i
  %57 = add i64 %.142, %lsr.iv451
  %58 = add i64 %57, 3
  %59 = add i64 %.142, %lsr.iv451
  %60 = add i64 %59, 2
  %.162.i.1 = icmp slt i64 %60, 0
  %61 = select i1 %.162.i.1, i64 %47, i64 2
  %scevgep468 = getelementptr i8, ptr %scevgep453, i64 %61
  %scevgep469 = getelementptr i8, ptr %scevgep468, i64 %lsr.iv451
  %.178.i.1 = load i8, ptr %scevgep469, align 1
  %.179.i.1 = zext i8 %.178.i.1 to i64
  %.181.i.1 = shl nuw nsw i64 %.179.i.1, 16
  %.183.i.1 = or i64 %.183.1.i, %.181.i.1
  %.162.1.i.1 = icmp slt i64 %58, 0
  %62 = select i1 %.162.1.i.1, i64 %48, i64 3
  %scevgep466 = getelementptr i8, ptr %scevgep453, i64 %62
  %scevgep467 = getelementptr i8, ptr %scevgep466, i64 %lsr.iv451
  %.178.1.i.1 = load i8, ptr %scevgep467, align 1
  %.179.1.i.1 = zext i8 %.178.1.i.1 to i64
  %.181.1.i.1 = shl nuw nsw i64 %.179.1.i.1, 24
  %.183.1.i.1 = or i64 %.183.i.1, %.181.1.i.1
  %63 = add i64 %.142, %lsr.iv451
  %64 = add i64 %63, 5
  %65 = add i64 %.142, %lsr.iv451
  %66 = add i64 %65, 4
  %.162.i.2 = icmp slt i64 %66, 0
  %67 = select i1 %.162.i.2, i64 %49, i64 4
  %scevgep458 = getelementptr i8, ptr %scevgep453, i64 %67
  %scevgep459 = getelementptr i8, ptr %scevgep458, i64 %lsr.iv451
  %.178.i.2 = load i8, ptr %scevgep459, align 1
  %.179.i.2 = zext i8 %.178.i.2 to i64
  %.181.i.2 = shl nuw nsw i64 %.179.i.2, 32
  %.183.i.2 = or i64 %.183.1.i.1, %.181.i.2
  %.162.1.i.2 = icmp slt i64 %64, 0
  %68 = select i1 %.162.1.i.2, i64 %50, i64 5
  %scevgep460 = getelementptr i8, ptr %scevgep453, i64 %68
  %scevgep461 = getelementptr i8, ptr %scevgep460, i64 %lsr.iv451
  %.178.1.i.2 = load i8, ptr %scevgep461, align 1
  %.179.1.i.2 = zext i8 %.178.1.i.2 to i64
  %.181.1.i.2 = shl nuw nsw i64 %.179.1.i.2, 40
  %.183.1.i.2 = or i64 %.183.i.2, %.181.1.i.2
  %69 = add i64 %.142, %lsr.iv451
  %70 = add i64 %69, 7
  %71 = add i64 %.142, %lsr.iv451
  %72 = add i64 %71, 6
  %.162.i.3 = icmp slt i64 %72, 0
  %73 = select i1 %.162.i.3, i64 %51, i64 6
  %scevgep454 = getelementptr i8, ptr %scevgep453, i64 %73
  %scevgep455 = getelementptr i8, ptr %scevgep454, i64 %lsr.iv451
  %.178.i.3 = load i8, ptr %scevgep455, align 1
  %.179.i.3 = zext i8 %.178.i.3 to i64
  %.181.i.3 = shl nuw nsw i64 %.179.i.3, 48
  %.183.i.3 = or i64 %.183.1.i.2, %.181.i.3
  %.162.1.i.3 = icmp slt i64 %70, 0
  %74 = select i1 %.162.1.i.3, i64 %52, i64 7
  %scevgep456 = getelementptr i8, ptr %scevgep453, i64 %74
  %scevgep457 = getelementptr i8, ptr %scevgep456, i64 %lsr.iv451
  %.178.1.i.3 = load i8, ptr %scevgep457, align 1
  %.179.1.i.3 = zext i8 %.178.1.i.3 to i64
  %.181.1.i.3 = shl nuw i64 %.179.1.i.3, 56
  %.183.1.i.3 = or i64 %.183.i.3, %.181.1.i.3
  %const_mat168 = add i64 %const167, 2
  %.545.us.us = xor i64 %.183.1.i.3, %const_mat168
  %.564.us.us = icmp slt i64 %lsr.iv473, 0
  %75 = select i1 %.564.us.us, i64 %53, i64 0
  %scevgep471 = getelementptr i8, ptr %scevgep470, i64 %75
  %scevgep472 = getelementptr i8, ptr %scevgep471, i64 %lsr.iv451
  store i64 %.545.us.us, ptr %scevgep472, align 8
  %lsr.iv.next452 = add nuw i64 %lsr.iv451, 8
  %lsr.iv.next474 = add i64 %lsr.iv473, 1
  %lsr.iv.next476 = add i64 %lsr.iv475, -1
  %exitcond813.not = icmp eq i64 %lsr.iv.next476, 0
  br i1 %exitcond813.not, label %B1062, label %B190.us.us
B190.us:                                          ; preds = %B190.us, %B190.us.preheader.new
  %.471680692.us = phi i64 [ 0, %B190.us.preheader.new ], [ %.478.us.1, %B190.us ]
  %76 = add i64 %.593.1, %.471680692.us
  %.641.us = icmp slt i64 %76, 0
  %77 = select i1 %.641.us, i64 %41, i64 0
  %scevgep487 = getelementptr i8, ptr %scevgep477, i64 %77
  %78 = shl i64 %.471680692.us, 2
  %scevgep488 = getelementptr i8, ptr %scevgep487, i64 %78
  %.657.us = load float, ptr %scevgep488, align 4
  %79 = add i64 %.197, %.471680692.us
  %.676.us = icmp slt i64 %79, 0
  %80 = select i1 %.676.us, i64 %42, i64 0
  %scevgep485 = getelementptr i8, ptr %scevgep481, i64 %80
  %81 = shl i64 %.471680692.us, 3
  %scevgep486 = getelementptr i8, ptr %scevgep485, i64 %81
  %.692.us = fpext float %.657.us to double
  store double %.692.us, ptr %scevgep486, align 8
  %.478.us.1 = add nuw i64 %.471680692.us, 2
  %82 = add i64 %.593.1, %.471680692.us
  %83 = add i64 %82, 1
  %.641.us.1 = icmp slt i64 %83, 0
  %84 = select i1 %.641.us.1, i64 %43, i64 4
  %scevgep95 = getelementptr i8, ptr %scevgep477, i64 %84
  %85 = shl i64 %.471680692.us, 2
  %scevgep113 = getelementptr i8, ptr %scevgep95, i64 %85
  %.657.us.1 = load float, ptr %scevgep113, align 4
  %86 = add i64 %.197, %.471680692.us
  %87 = add i64 %86, 1
  %.676.us.1 = icmp slt i64 %87, 0
  %88 = select i1 %.676.us.1, i64 %44, i64 8
  %scevgep = getelementptr i8, ptr %scevgep481, i64 %88
  %89 = shl i64 %.471680692.us, 3
  %scevgep111 = getelementptr i8, ptr %scevgep, i64 %89
  %.692.us.1 = fpext float %.657.us.1 to double
  store double %.692.us.1, ptr %scevgep111, align 8
  %niter431.ncmp.1 = icmp eq i64 %unroll_iter430, %.478.us.1
  br i1 %niter431.ncmp.1, label %B1062.loopexit413.unr-lcssa, label %B190.us
B190.us700:                                       ; preds = %B520.us, %B190.us700.preheader
  %lsr.iv491 = phi i64 [ %lsr.iv.next492, %B520.us ], [ %.142, %B190.us700.preheader ]
  %.471680692.us702 = phi i64 [ %.478.us704, %B520.us ], [ 0, %B190.us700.preheader ]
  %90 = icmp slt i64 %.252, 1
  %.478.us704 = add nuw nsw i64 %.471680692.us702, 1
  %.700.us = mul nsw i64 %.471680692.us702, %.252
  br i1 %90, label %B390.endif.us.thread, label %B76.preheader.i
B390.endif.us.thread:                             ; preds = %B190.us700
  call void @llvm.lifetime.start.p0(ptr nonnull %.70.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %excinfo.2.i)
  br label %B390.endif.endif.us.thread335
B76.preheader.i:                                  ; preds = %B190.us700
  %91 = icmp eq i64 %.252, 1
  br i1 %91, label %B76.epil.preheader.i, label %B76.i33.preheader
B76.i33.preheader:                                ; preds = %B76.preheader.i
  br label %B76.i33
B76.i33:                                          ; preds = %B76.i33.preheader, %B76.i33
  %lsr.iv116 = phi i64 [ %lsr.iv491, %B76.i33.preheader ], [ %lsr.iv.next117, %B76.i33 ]
  %lsr.iv114 = phi i64 [ %32, %B76.i33.preheader ], [ %lsr.iv.next115, %B76.i33 ]
  %lsr.iv6.i35 = phi i64 [ %lsr.iv.next7.i54, %B76.i33 ], [ 8, %B76.i33.preheader ]
  %value.3.0109.i38 = phi i64 [ %.183.1.i51, %B76.i33 ], [ 0, %B76.i33.preheader ]
  %.162.i39 = icmp slt i64 %lsr.iv116, 0
  %.163.i40 = select i1 %.162.i39, i64 %arg.raw.5.0, i64 0
  %scevgep122 = getelementptr i8, ptr %arg.raw.4, i64 %.163.i40
  %scevgep126 = getelementptr i8, ptr %scevgep122, i64 %lsr.iv116
  %.178.i42 = load i8, ptr %scevgep126, align 1
  %.179.i43 = zext i8 %.178.i42 to i64
  %92 = add i64 %lsr.iv6.i35, -8
  %.181.i44 = shl i64 %.179.i43, %92
  %.183.i45 = or i64 %.181.i44, %value.3.0109.i38
  %93 = add i64 %lsr.iv116, 1
  %.162.1.i46 = icmp slt i64 %93, 0
  %94 = select i1 %.162.1.i46, i64 %33, i64 1
  %scevgep118 = getelementptr i8, ptr %arg.raw.4, i64 %94
  %scevgep120 = getelementptr i8, ptr %scevgep118, i64 %lsr.iv116
  %.178.1.i48 = load i8, ptr %scevgep120, align 1
  %.179.1.i49 = zext i8 %.178.1.i48 to i64
  %.181.1.i50 = shl i64 %.179.1.i49, %lsr.iv6.i35
  %.183.1.i51 = or i64 %.183.i45, %.181.1.i50
  %lsr.iv.next7.i54 = add i64 %lsr.iv6.i35, 16
  %lsr.iv.next115 = add i64 %lsr.iv114, -2
  %lsr.iv.next117 = add i64 %lsr.iv116, 2
  %niter.ncmp.1.i56 = icmp eq i64 %lsr.iv.next115, 0
  br i1 %niter.ncmp.1.i56, label %B192.loopexit.unr-lcssa.i, label %B76.i33
B192.loopexit.unr-lcssa.i:                        ; preds = %B76.i33
  %95 = and i64 %.252, 1
  %96 = icmp eq i64 %95, 0
  br i1 %96, label %B390.endif.us, label %B76.epil.preheader.i
B76.epil.preheader.i:                             ; preds = %B192.loopexit.unr-lcssa.i, %B76.preheader.i
  %value.3.0109.epil.init.i = phi i64 [ 0, %B76.preheader.i ], [ %.183.1.i51, %B192.loopexit.unr-lcssa.i ]
  %.148.epil.i = add i64 %.702.us, %.700.us
  %.162.epil.i = icmp slt i64 %.148.epil.i, 0
  %.163.epil.i = select i1 %.162.epil.i, i64 %arg.raw.5.0, i64 0
  %97 = getelementptr i8, ptr %arg.raw.4, i64 %.148.epil.i
  %.177.epil.i = getelementptr i8, ptr %97, i64 %.163.epil.i
  %.178.epil.i = load i8, ptr %.177.epil.i, align 1
  %.179.epil.i = zext i8 %.178.epil.i to i64
  %.181.epil.i = shl i64 %.179.epil.i, %.180.epil.i
  %.183.epil.i = or i64 %.181.epil.i, %value.3.0109.epil.init.i
  br label %B390.endif.us
B390.endif.us:                                    ; preds = %B76.epil.preheader.i, %B192.loopexit.unr-lcssa.i
  %value.3.0.lcssa.i = phi i64 [ %.183.epil.i, %B76.epil.preheader.i ], [ %.183.1.i51, %B192.loopexit.unr-lcssa.i ]
  call void @llvm.lifetime.start.p0(ptr nonnull %.70.i)
  call void @llvm.lifetime.start.p0(ptr nonnull %excinfo.2.i)
  %.30.i = icmp eq i64 %value.3.0.lcssa.i, 0
  br i1 %.30.i, label %B390.endif.endif.us.thread335, label %B20.i
B20.i:                                            ; preds = %B390.endif.us
  %.5.i.i.i = inttoptr i64 %value.3.0.lcssa.i to ptr
  %.6.i.i.i = load i8, ptr %.5.i.i.i, align 1
  %.41.not.i.i = icmp eq i8 %.6.i.i.i, 0
  br i1 %.41.not.i.i, label %B20.endif.i, label %B52.endif.preheader.i.i
B52.endif.preheader.i.i:                          ; preds = %B20.i
  %98 = inttoptr i64 %value.3.0.lcssa.i to ptr
  %scevgep.i.i = getelementptr i8, ptr %98, i64 1
  %strlen.i.i = tail call i64 @strlen(ptr noundef nonnull dereferenceable(1) %scevgep.i.i)
  %99 = add i64 %strlen.i.i, 1
  br label %B20.endif.i
B20.endif.i:                                      ; preds = %B52.endif.preheader.i.i, %B20.i
  %length.3.1.i.i = phi i64 [ 0, %B20.i ], [ %99, %B52.endif.preheader.i.i ]
  store i64 0, ptr %.70.i, align 8
  %.78.i = call i32 @f80(ptr nonnull %.70.i, ptr nonnull %excinfo.2.i, i64 %value.3.0.lcssa.i, i64 %length.3.1.i.i, ptr readnone %arg.pool.0, ptr readnone %arg.pool.1, i64 %arg.pool.2, i64 %arg.pool.3, ptr %arg.pool.4, i64 %arg.pool.5.0, i64 %arg.pool.6.0, ptr readnone %arg.index.0, ptr readnone %arg.index.1, i64 %arg.index.2, i64 %arg.index.3, ptr %arg.index.4, i64 %arg.index.5.0, i64 %arg.index.6.0)
  %cond.i = icmp eq i32 %.78.i, 0
  br i1 %cond.i, label %B390.endif.endif.us, label %_ZN8rovbrush12orchestrator4loop5texts9number_ofB3v31B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dEx5ArrayIhLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit
_ZN8rovbrush12orchestrator4loop5texts9number_ofB3v31B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dEx5ArrayIhLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit: ; preds = %B20.endif.i
  call void @llvm.lifetime.end.p0(ptr nonnull %.70.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.2.i)
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
B390.endif.endif.us.thread335:                    ; preds = %B390.endif.us, %B390.endif.us.thread
  call void @llvm.lifetime.end.p0(ptr nonnull %.70.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.2.i)
  br label %B520.us
B390.endif.endif.us:                              ; preds = %B20.endif.i
  %.88.i = load i64, ptr %.70.i, align 8
  call void @llvm.lifetime.end.p0(ptr nonnull %.70.i)
  call void @llvm.lifetime.end.p0(ptr nonnull %excinfo.2.i)
  %.765.us = icmp slt i64 %.88.i, 0
  br i1 %.765.us, label %B480.endif, label %B520.us
B520.us:                                          ; preds = %B390.endif.endif.us, %B390.endif.endif.us.thread335
  %.733.0328332 = phi i64 [ 0, %B390.endif.endif.us.thread335 ], [ %.88.i, %B390.endif.endif.us ]
  %.828.us = add nsw i64 %.471680692.us702, %.197
  %.845.us = icmp slt i64 %.828.us, 0
  %.846.us = select i1 %.845.us, i64 %arg.whole.5.0, i64 0
  %100 = getelementptr i64, ptr %arg.whole.4, i64 %.828.us
  %.860.us = getelementptr i64, ptr %100, i64 %.846.us
  store i64 %.733.0328332, ptr %.860.us, align 8
  %lsr.iv.next492 = add i64 %lsr.iv491, %.252
  %exitcond811.not = icmp eq i64 %.382, %.478.us704
  br i1 %exitcond811.not, label %B1062, label %B190.us700
B190.us721:                                       ; preds = %B560.endif.us, %B190.us721.preheader373
  %lsr.iv519 = phi i64 [ %lsr.iv.next520, %B560.endif.us ], [ %.142, %B190.us721.preheader373 ]
  %.471680692.us723 = phi i64 [ %.478.us725, %B560.endif.us ], [ 0, %B190.us721.preheader373 ]
  %101 = icmp eq i64 %.252, 1
  %.870.us = mul nuw nsw i64 %.471680692.us723, %.252
  br i1 %101, label %B76.epil.preheader.i88, label %B76.i62.preheader
B76.i62.preheader:                                ; preds = %B190.us721
  br label %B76.i62
B76.i62:                                          ; preds = %B76.i62.preheader, %B76.i62
  %lsr.iv135 = phi i64 [ %lsr.iv519, %B76.i62.preheader ], [ %lsr.iv.next136, %B76.i62 ]
  %lsr.iv = phi i64 [ %16, %B76.i62.preheader ], [ %lsr.iv.next, %B76.i62 ]
  %lsr.iv6.i64 = phi i64 [ %lsr.iv.next7.i83, %B76.i62 ], [ 8, %B76.i62.preheader ]
  %value.3.0109.i67 = phi i64 [ %.183.1.i80, %B76.i62 ], [ 0, %B76.i62.preheader ]
  %.162.i68 = icmp slt i64 %lsr.iv135, 0
  %.163.i69 = select i1 %.162.i68, i64 %arg.raw.5.0, i64 0
  %scevgep142 = getelementptr i8, ptr %arg.raw.4, i64 %.163.i69
  %scevgep143 = getelementptr i8, ptr %scevgep142, i64 %lsr.iv135
  %.178.i71 = load i8, ptr %scevgep143, align 1
  %.179.i72 = zext i8 %.178.i71 to i64
  %102 = add i64 %lsr.iv6.i64, -8
  %.181.i73 = shl i64 %.179.i72, %102
  %.183.i74 = or i64 %.181.i73, %value.3.0109.i67
  %103 = add i64 %lsr.iv135, 1
  %.162.1.i75 = icmp slt i64 %103, 0
  %104 = select i1 %.162.1.i75, i64 %9, i64 1
  %scevgep137 = getelementptr i8, ptr %arg.raw.4, i64 %104
  %scevgep141 = getelementptr i8, ptr %scevgep137, i64 %lsr.iv135
  %.178.1.i77 = load i8, ptr %scevgep141, align 1
  %.179.1.i78 = zext i8 %.178.1.i77 to i64
  %.181.1.i79 = shl i64 %.179.1.i78, %lsr.iv6.i64
  %.183.1.i80 = or i64 %.183.i74, %.181.1.i79
  %lsr.iv.next7.i83 = add i64 %lsr.iv6.i64, 16
  %lsr.iv.next = add i64 %lsr.iv, -2
  %lsr.iv.next136 = add i64 %lsr.iv135, 2
  %niter.ncmp.1.i85 = icmp eq i64 %lsr.iv.next, 0
  br i1 %niter.ncmp.1.i85, label %B192.loopexit.unr-lcssa.i86, label %B76.i62
B192.loopexit.unr-lcssa.i86:                      ; preds = %B76.i62
  %105 = and i64 %.252, 1
  %106 = icmp eq i64 %105, 0
  br i1 %106, label %B560.endif.us, label %B76.epil.preheader.i88
B76.epil.preheader.i88:                           ; preds = %B192.loopexit.unr-lcssa.i86, %B190.us721
  %value.3.0109.epil.init.i89 = phi i64 [ 0, %B190.us721 ], [ %.183.1.i80, %B192.loopexit.unr-lcssa.i86 ]
  %.148.epil.i91 = add i64 %.872.us, %.870.us
  %.162.epil.i92 = icmp slt i64 %.148.epil.i91, 0
  %.163.epil.i93 = select i1 %.162.epil.i92, i64 %arg.raw.5.0, i64 0
  %107 = getelementptr i8, ptr %arg.raw.4, i64 %.148.epil.i91
  %.177.epil.i94 = getelementptr i8, ptr %107, i64 %.163.epil.i93
  %.178.epil.i95 = load i8, ptr %.177.epil.i94, align 1
  %.179.epil.i96 = zext i8 %.178.epil.i95 to i64
  %.181.epil.i98 = shl i64 %.179.epil.i96, %.180.epil.i97
  %.183.epil.i99 = or i64 %.181.epil.i98, %value.3.0109.epil.init.i89
  br label %B560.endif.us
B560.endif.us:                                    ; preds = %B76.epil.preheader.i88, %B192.loopexit.unr-lcssa.i86
  %value.3.0.lcssa.i100 = phi i64 [ %.183.epil.i99, %B76.epil.preheader.i88 ], [ %.183.1.i80, %B192.loopexit.unr-lcssa.i86 ]
  %.478.us725 = add nuw nsw i64 %.471680692.us723, 1
  %.901.us = icmp ne i64 %value.3.0.lcssa.i100, 0
  %.904.us = add nsw i64 %.471680692.us723, %.197
  %.920.us = icmp slt i64 %.904.us, 0
  %.921.us = select i1 %.920.us, i64 %arg.whole.5.0, i64 0
  %108 = getelementptr i64, ptr %arg.whole.4, i64 %.904.us
  %.935.us = getelementptr i64, ptr %108, i64 %.921.us
  %.937.us = zext i1 %.901.us to i64
  store i64 %.937.us, ptr %.935.us, align 8
  %lsr.iv.next520 = add i64 %lsr.iv519, %.252
  %exitcond810.not = icmp eq i64 %.382, %.478.us725
  br i1 %exitcond810.not, label %B1062, label %B190.us721
B190.us736:                                       ; preds = %B652.endif.us, %B190.us736.preheader
  %lsr.iv529 = phi i64 [ %lsr.iv.next530, %B652.endif.us ], [ %.142, %B190.us736.preheader ]
  %.471680692.us738 = phi i64 [ %.478.us740, %B652.endif.us ], [ 0, %B190.us736.preheader ]
  %109 = icmp slt i64 %.252, 1
  %.945.us = mul nsw i64 %.471680692.us738, %.252
  %.947.us = add nsw i64 %.945.us, %.142
  br i1 %109, label %B208.i, label %B76.preheader.i104
B76.preheader.i104:                               ; preds = %B190.us736
  %110 = icmp eq i64 %.252, 1
  br i1 %110, label %B76.epil.preheader.i133, label %B76.i107.preheader
B76.i107.preheader:                               ; preds = %B76.preheader.i104
  br label %B76.i107
B76.i107:                                         ; preds = %B76.i107.preheader, %B76.i107
  %lsr.iv146 = phi i64 [ %lsr.iv529, %B76.i107.preheader ], [ %lsr.iv.next147, %B76.i107 ]
  %lsr.iv144 = phi i64 [ %6, %B76.i107.preheader ], [ %lsr.iv.next145, %B76.i107 ]
  %lsr.iv6.i109 = phi i64 [ %lsr.iv.next7.i128, %B76.i107 ], [ 8, %B76.i107.preheader ]
  %value.3.0109.i112 = phi i64 [ %.183.1.i125, %B76.i107 ], [ 0, %B76.i107.preheader ]
  %.162.i113 = icmp slt i64 %lsr.iv146, 0
  %.163.i114 = select i1 %.162.i113, i64 %arg.raw.5.0, i64 0
  %scevgep150 = getelementptr i8, ptr %arg.raw.4, i64 %.163.i114
  %scevgep151 = getelementptr i8, ptr %scevgep150, i64 %lsr.iv146
  %.178.i116 = load i8, ptr %scevgep151, align 1
  %.179.i117 = zext i8 %.178.i116 to i64
  %111 = add i64 %lsr.iv6.i109, -8
  %.181.i118 = shl i64 %.179.i117, %111
  %.183.i119 = or i64 %.181.i118, %value.3.0109.i112
  %112 = add i64 %lsr.iv146, 1
  %.162.1.i120 = icmp slt i64 %112, 0
  %113 = select i1 %.162.1.i120, i64 %7, i64 1
  %scevgep148 = getelementptr i8, ptr %arg.raw.4, i64 %113
  %scevgep149 = getelementptr i8, ptr %scevgep148, i64 %lsr.iv146
  %.178.1.i122 = load i8, ptr %scevgep149, align 1
  %.179.1.i123 = zext i8 %.178.1.i122 to i64
  %.181.1.i124 = shl i64 %.179.1.i123, %lsr.iv6.i109
  %.183.1.i125 = or i64 %.183.i119, %.181.1.i124
  %lsr.iv.next7.i128 = add i64 %lsr.iv6.i109, 16
  %lsr.iv.next145 = add i64 %lsr.iv144, -2
  %lsr.iv.next147 = add i64 %lsr.iv146, 2
  %niter.ncmp.1.i130 = icmp eq i64 %lsr.iv.next145, 0
  br i1 %niter.ncmp.1.i130, label %B192.loopexit.unr-lcssa.i131, label %B76.i107
B192.loopexit.unr-lcssa.i131:                     ; preds = %B76.i107
  %114 = and i64 %.252, 1
  %115 = icmp eq i64 %114, 0
  br i1 %115, label %B192.i, label %B76.epil.preheader.i133
B76.epil.preheader.i133:                          ; preds = %B192.loopexit.unr-lcssa.i131, %B76.preheader.i104
  %value.3.0109.epil.init.i134 = phi i64 [ 0, %B76.preheader.i104 ], [ %.183.1.i125, %B192.loopexit.unr-lcssa.i131 ]
  %.148.epil.i136 = add nsw i64 %.947.us, %8
  %.162.epil.i137 = icmp slt i64 %.148.epil.i136, 0
  %.163.epil.i138 = select i1 %.162.epil.i137, i64 %arg.raw.5.0, i64 0
  %116 = getelementptr i8, ptr %arg.raw.4, i64 %.148.epil.i136
  %.177.epil.i139 = getelementptr i8, ptr %116, i64 %.163.epil.i138
  %.178.epil.i140 = load i8, ptr %.177.epil.i139, align 1
  %.179.epil.i141 = zext i8 %.178.epil.i140 to i64
  %.181.epil.i143 = shl i64 %.179.epil.i141, %.180.epil.i142
  %.183.epil.i144 = or i64 %.181.epil.i143, %value.3.0109.epil.init.i134
  br label %B192.i
B192.i:                                           ; preds = %B76.epil.preheader.i133, %B192.loopexit.unr-lcssa.i131
  %value.3.0.lcssa.i145 = phi i64 [ %.183.epil.i144, %B76.epil.preheader.i133 ], [ %.183.1.i125, %B192.loopexit.unr-lcssa.i131 ]
  %117 = icmp ult i64 %.252, 8
  br i1 %117, label %B208.i, label %B652.endif.us
B208.i:                                           ; preds = %B192.i, %B190.us736
  %value.3.0.lcssa.i145340 = phi i64 [ %value.3.0.lcssa.i145, %B192.i ], [ 0, %B190.us736 ]
  %.211.i = add nsw i64 %.947.us, %.252
  %.228.inv.i = icmp sgt i64 %.211.i, 0
  %.229.i = select i1 %.228.inv.i, i64 0, i64 %arg.raw.5.0
  %118 = getelementptr i8, ptr %arg.raw.4, i64 %.211.i
  %119 = getelementptr i8, ptr %118, i64 -1
  %.243.i = getelementptr i8, ptr %119, i64 %.229.i
  %.244.i = load i8, ptr %.243.i, align 1
  %.248.i = icmp slt i8 %.244.i, 0
  %.256.i = select i1 %.248.i, i64 %.254.neg.i, i64 0
  %spec.select = add i64 %.256.i, %value.3.0.lcssa.i145340
  br label %B652.endif.us
B652.endif.us:                                    ; preds = %B208.i, %B192.i
  %value.4.0.i = phi i64 [ %value.3.0.lcssa.i145, %B192.i ], [ %spec.select, %B208.i ]
  %.478.us740 = add nuw nsw i64 %.471680692.us738, 1
  %.976.us = sub i64 0, %value.4.0.i
  %.979.us = add nsw i64 %.471680692.us738, %.197
  %.995.us = icmp slt i64 %.979.us, 0
  %.996.us = select i1 %.995.us, i64 %arg.whole.5.0, i64 0
  %120 = getelementptr i64, ptr %arg.whole.4, i64 %.979.us
  %.1010.us = getelementptr i64, ptr %120, i64 %.996.us
  store i64 %.976.us, ptr %.1010.us, align 8
  %lsr.iv.next530 = add i64 %lsr.iv529, %.252
  %exitcond809.not = icmp eq i64 %.382, %.478.us740
  br i1 %exitcond809.not, label %B1062, label %B190.us736
B190.us751:                                       ; preds = %B952.us, %B190.us751.preheader
  %.471680692.us753 = phi i64 [ %.478.us755, %B952.us ], [ 0, %B190.us751.preheader ]
  %121 = icmp slt i64 %.252, 1
  %.478.us755 = add nuw nsw i64 %.471680692.us753, 1
  %sunkaddr170 = mul i64 %.137, 8
  %sunkaddr171 = getelementptr i8, ptr %arg.blocks.4, i64 %sunkaddr170
  %sunkaddr172 = getelementptr i8, ptr %sunkaddr171, i64 32
  %.1070.us = load i64, ptr %sunkaddr172, align 8
  %.1072.us = add i64 %.1070.us, %.471680692.us753
  %.1074.us = mul i64 %.1072.us, %.252
  %.1076.us = add i64 %.1074.us, %.142
  br i1 %121, label %B740.endif.endif.us, label %B76.preheader.i149
B76.preheader.i149:                               ; preds = %B190.us751
  %122 = icmp eq i64 %.252, 1
  br i1 %122, label %B76.preheader.i207, label %B76.i152.preheader
B76.i152.preheader:                               ; preds = %B76.preheader.i149
  %scevgep129 = getelementptr i8, ptr %scevgep128, i64 %.1074.us
  br label %B76.i152
B76.i152:                                         ; preds = %B76.i152, %B76.i152.preheader
  %lsr.iv152 = phi i64 [ %lsr.iv.next153, %B76.i152 ], [ %5, %B76.i152.preheader ]
  %lsr.iv130 = phi ptr [ %scevgep129, %B76.i152.preheader ], [ %scevgep131, %B76.i152 ]
  %lsr.iv539 = phi i64 [ %.1076.us, %B76.i152.preheader ], [ %126, %B76.i152 ]
  %lsr.iv6.i154 = phi i64 [ 8, %B76.i152.preheader ], [ %lsr.iv.next7.i173, %B76.i152 ]
  %value.3.0109.i157 = phi i64 [ 0, %B76.i152.preheader ], [ %.183.1.i170, %B76.i152 ]
  %.162.i158 = icmp slt i64 %lsr.iv539, 0
  %.163.i159 = select i1 %.162.i158, i64 %arg.raw.5.0, i64 0
  %scevgep133 = getelementptr i8, ptr %lsr.iv130, i64 %.163.i159
  %.178.i161 = load i8, ptr %scevgep133, align 1
  %.179.i162 = zext i8 %.178.i161 to i64
  %123 = add i64 %lsr.iv6.i154, -8
  %.181.i163 = shl i64 %.179.i162, %123
  %.183.i164 = or i64 %.181.i163, %value.3.0109.i157
  %124 = add i64 %lsr.iv539, 1
  %.162.1.i165 = icmp slt i64 %124, 0
  %125 = select i1 %.162.1.i165, i64 %2, i64 1
  %scevgep132 = getelementptr i8, ptr %lsr.iv130, i64 %125
  %.178.1.i167 = load i8, ptr %scevgep132, align 1
  %.179.1.i168 = zext i8 %.178.1.i167 to i64
  %.181.1.i169 = shl i64 %.179.1.i168, %lsr.iv6.i154
  %.183.1.i170 = or i64 %.183.i164, %.181.1.i169
  %lsr.iv.next7.i173 = add i64 %lsr.iv6.i154, 16
  %scevgep131 = getelementptr i8, ptr %lsr.iv130, i64 2
  %lsr.iv.next153 = add i64 %lsr.iv152, 2
  %niter.ncmp.1.i175 = icmp eq i64 %lsr.iv.next153, 0
  %126 = add i64 %124, 1
  br i1 %niter.ncmp.1.i175, label %B192.loopexit.unr-lcssa.i176, label %B76.i152
B192.loopexit.unr-lcssa.i176:                     ; preds = %B76.i152
  %127 = and i64 %.252, 1
  %128 = icmp eq i64 %127, 0
  br i1 %128, label %B76.preheader.i207.thread, label %B76.preheader.i207
B76.preheader.i207.thread:                        ; preds = %B192.loopexit.unr-lcssa.i176
  %.1107.us342348 = mul nuw nsw i64 %.471680692.us753, %.252
  %.1109.us343349 = add nsw i64 %.1107.us342348, %.142
  br label %B76.preheader.new.i208
B76.preheader.i207:                               ; preds = %B192.loopexit.unr-lcssa.i176, %B76.preheader.i149
  %value.3.0109.epil.init.i179 = phi i64 [ 0, %B76.preheader.i149 ], [ %.183.1.i170, %B192.loopexit.unr-lcssa.i176 ]
  %129 = icmp eq i64 %.252, 1
  %.148.epil.i181 = add nsw i64 %.1076.us, %3
  %.162.epil.i182 = icmp slt i64 %.148.epil.i181, 0
  %.163.epil.i183 = select i1 %.162.epil.i182, i64 %arg.raw.5.0, i64 0
  %130 = getelementptr i8, ptr %arg.raw.4, i64 %.148.epil.i181
  %.177.epil.i184 = getelementptr i8, ptr %130, i64 %.163.epil.i183
  %.178.epil.i185 = load i8, ptr %.177.epil.i184, align 1
  %.179.epil.i186 = zext i8 %.178.epil.i185 to i64
  %.181.epil.i188 = shl i64 %.179.epil.i186, %.180.epil.i187
  %.183.epil.i189 = or i64 %.181.epil.i188, %value.3.0109.epil.init.i179
  %.1107.us342 = mul nuw nsw i64 %.471680692.us753, %.252
  %.1109.us343 = add nsw i64 %.1107.us342, %.142
  br i1 %129, label %B76.epil.preheader.i236, label %B76.preheader.new.i208
B76.preheader.new.i208:                           ; preds = %B76.preheader.i207, %B76.preheader.i207.thread
  %.1109.us343352 = phi i64 [ %.1109.us343349, %B76.preheader.i207.thread ], [ %.1109.us343, %B76.preheader.i207 ]
  %value.3.0.lcssa.i191.ph350 = phi i64 [ %.183.1.i170, %B76.preheader.i207.thread ], [ %.183.epil.i189, %B76.preheader.i207 ]
  br label %B76.i210
B76.i210:                                         ; preds = %B76.i210, %B76.preheader.new.i208
  %lsr.iv156 = phi i64 [ %lsr.iv.next157, %B76.i210 ], [ %.1109.us343352, %B76.preheader.new.i208 ]
  %lsr.iv154 = phi i64 [ %lsr.iv.next155, %B76.i210 ], [ %1, %B76.preheader.new.i208 ]
  %lsr.iv6.i212 = phi i64 [ %lsr.iv.next7.i231, %B76.i210 ], [ 8, %B76.preheader.new.i208 ]
  %value.3.0109.i215 = phi i64 [ %.183.1.i228, %B76.i210 ], [ 0, %B76.preheader.new.i208 ]
  %.162.i216 = icmp slt i64 %lsr.iv156, 0
  %.163.i217 = select i1 %.162.i216, i64 %arg.raw.5.0, i64 0
  %scevgep160 = getelementptr i8, ptr %arg.raw.4, i64 %.163.i217
  %scevgep161 = getelementptr i8, ptr %scevgep160, i64 %lsr.iv156
  %.178.i219 = load i8, ptr %scevgep161, align 1
  %.179.i220 = zext i8 %.178.i219 to i64
  %131 = add i64 %lsr.iv6.i212, -8
  %.181.i221 = shl i64 %.179.i220, %131
  %.183.i222 = or i64 %.181.i221, %value.3.0109.i215
  %132 = add i64 %lsr.iv156, 1
  %.162.1.i223 = icmp slt i64 %132, 0
  %133 = select i1 %.162.1.i223, i64 %2, i64 1
  %scevgep158 = getelementptr i8, ptr %arg.raw.4, i64 %133
  %scevgep159 = getelementptr i8, ptr %scevgep158, i64 %lsr.iv156
  %.178.1.i225 = load i8, ptr %scevgep159, align 1
  %.179.1.i226 = zext i8 %.178.1.i225 to i64
  %.181.1.i227 = shl i64 %.179.1.i226, %lsr.iv6.i212
  %.183.1.i228 = or i64 %.183.i222, %.181.1.i227
  %lsr.iv.next7.i231 = add i64 %lsr.iv6.i212, 16
  %lsr.iv.next155 = add i64 %lsr.iv154, -2
  %lsr.iv.next157 = add i64 %lsr.iv156, 2
  %niter.ncmp.1.i233 = icmp eq i64 %lsr.iv.next155, 0
  br i1 %niter.ncmp.1.i233, label %B192.loopexit.unr-lcssa.i234, label %B76.i210
B192.loopexit.unr-lcssa.i234:                     ; preds = %B76.i210
  %134 = and i64 %.252, 1
  %135 = icmp eq i64 %134, 0
  br i1 %135, label %B740.endif.endif.us, label %B76.epil.preheader.i236
B76.epil.preheader.i236:                          ; preds = %B192.loopexit.unr-lcssa.i234, %B76.preheader.i207
  %.1109.us343353 = phi i64 [ %.1109.us343, %B76.preheader.i207 ], [ %.1109.us343352, %B192.loopexit.unr-lcssa.i234 ]
  %value.3.0.lcssa.i191.ph351 = phi i64 [ %.183.epil.i189, %B76.preheader.i207 ], [ %value.3.0.lcssa.i191.ph350, %B192.loopexit.unr-lcssa.i234 ]
  %value.3.0109.epil.init.i237 = phi i64 [ 0, %B76.preheader.i207 ], [ %.183.1.i228, %B192.loopexit.unr-lcssa.i234 ]
  %.148.epil.i239 = add nsw i64 %.1109.us343353, %3
  %.162.epil.i240 = icmp slt i64 %.148.epil.i239, 0
  %.163.epil.i241 = select i1 %.162.epil.i240, i64 %arg.raw.5.0, i64 0
  %136 = getelementptr i8, ptr %arg.raw.4, i64 %.148.epil.i239
  %.177.epil.i242 = getelementptr i8, ptr %136, i64 %.163.epil.i241
  %.178.epil.i243 = load i8, ptr %.177.epil.i242, align 1
  %.179.epil.i244 = zext i8 %.178.epil.i243 to i64
  %.181.epil.i246 = shl i64 %.179.epil.i244, %.180.epil.i187
  %.183.epil.i247 = or i64 %.181.epil.i246, %value.3.0109.epil.init.i237
  br label %B740.endif.endif.us
B740.endif.endif.us:                              ; preds = %B76.epil.preheader.i236, %B192.loopexit.unr-lcssa.i234, %B190.us751
  %value.3.0.lcssa.i191345 = phi i64 [ %value.3.0.lcssa.i191.ph351, %B76.epil.preheader.i236 ], [ %value.3.0.lcssa.i191.ph350, %B192.loopexit.unr-lcssa.i234 ], [ 0, %B190.us751 ]
  %value.3.0.lcssa.i249 = phi i64 [ %.183.epil.i247, %B76.epil.preheader.i236 ], [ %.183.1.i228, %B192.loopexit.unr-lcssa.i234 ], [ 0, %B190.us751 ]
  store i64 0, ptr %.1140, align 8
  %.1148.us = call i32 @f80(ptr nonnull %.1140, ptr nonnull %excinfo.9, i64 %value.3.0.lcssa.i249, i64 %value.3.0.lcssa.i191345, ptr %arg.pool.0, ptr %arg.pool.1, i64 %arg.pool.2, i64 %arg.pool.3, ptr %arg.pool.4, i64 %arg.pool.5.0, i64 %arg.pool.6.0, ptr %arg.index.0, ptr %arg.index.1, i64 %arg.index.2, i64 %arg.index.3, ptr %arg.index.4, i64 %arg.index.5.0, i64 %arg.index.6.0)
  %.1158.us = load i64, ptr %.1140, align 8
  %cond354 = icmp eq i32 %.1148.us, 0
  br i1 %cond354, label %B740.endif.endif.endif.us, label %B740.endif.endif.if.if
B740.endif.endif.endif.us:                        ; preds = %B740.endif.endif.us
  %.1172.us = icmp slt i64 %.1158.us, 0
  %.1202 = add nsw i64 %.471680692.us753, %.197
  br i1 %.1172.us, label %B912.endif, label %B952.us
B952.us:                                          ; preds = %B740.endif.endif.endif.us
  %.1252.us = icmp slt i64 %.1202, 0
  %.1253.us = select i1 %.1252.us, i64 %arg.whole.5.0, i64 0
  %137 = getelementptr i64, ptr %arg.whole.4, i64 %.1202
  %.1267.us = getelementptr i64, ptr %137, i64 %.1253.us
  store i64 %.1158.us, ptr %.1267.us, align 8
  %exitcond.not = icmp eq i64 %.382, %.478.us755
  br i1 %exitcond.not, label %B1062, label %B190.us751
B190:                                             ; preds = %B972.endif, %B190.preheader
  %lsr.iv444 = phi i64 [ %lsr.iv.next445, %B972.endif ], [ %.142, %B190.preheader ]
  %.471680692 = phi i64 [ %.478, %B972.endif ], [ 0, %B190.preheader ]
  %138 = icmp slt i64 %.252, 1
  %.1274 = mul nsw i64 %.471680692, %.252
  %.1276 = add nsw i64 %.1274, %.142
  %sunkaddr173 = mul i64 %.137, 8
  %sunkaddr174 = getelementptr i8, ptr %arg.blocks.4, i64 %sunkaddr173
  %sunkaddr175 = getelementptr i8, ptr %sunkaddr174, i64 72
  %.1331 = load i64, ptr %sunkaddr175, align 8
  br i1 %138, label %B192.i306, label %B76.preheader.i265
B76.preheader.i265:                               ; preds = %B190
  %139 = icmp eq i64 %.252, 1
  br i1 %139, label %B76.epil.preheader.i294, label %B76.i268.preheader
B76.i268.preheader:                               ; preds = %B76.preheader.i265
  br label %B76.i268
B76.i268:                                         ; preds = %B76.i268.preheader, %B76.i268
  %lsr.iv87 = phi i64 [ %lsr.iv444, %B76.i268.preheader ], [ %lsr.iv.next88, %B76.i268 ]
  %lsr.iv85 = phi i64 [ %35, %B76.i268.preheader ], [ %lsr.iv.next86, %B76.i268 ]
  %lsr.iv6.i270 = phi i64 [ %lsr.iv.next7.i289, %B76.i268 ], [ 8, %B76.i268.preheader ]
  %value.3.0109.i273 = phi i64 [ %.183.1.i286, %B76.i268 ], [ 0, %B76.i268.preheader ]
  %.162.i274 = icmp slt i64 %lsr.iv87, 0
  %.163.i275 = select i1 %.162.i274, i64 %arg.raw.5.0, i64 0
  %scevgep99 = getelementptr i8, ptr %arg.raw.4, i64 %.163.i275
  %scevgep103 = getelementptr i8, ptr %scevgep99, i64 %lsr.iv87
  %.178.i277 = load i8, ptr %scevgep103, align 1
  %.179.i278 = zext i8 %.178.i277 to i64
  %140 = add i64 %lsr.iv6.i270, -8
  %.181.i279 = shl i64 %.179.i278, %140
  %.183.i280 = or i64 %.181.i279, %value.3.0109.i273
  %141 = add i64 %lsr.iv87, 1
  %.162.1.i281 = icmp slt i64 %141, 0
  %142 = select i1 %.162.1.i281, i64 %36, i64 1
  %scevgep92 = getelementptr i8, ptr %arg.raw.4, i64 %142
  %scevgep93 = getelementptr i8, ptr %scevgep92, i64 %lsr.iv87
  %.178.1.i283 = load i8, ptr %scevgep93, align 1
  %.179.1.i284 = zext i8 %.178.1.i283 to i64
  %.181.1.i285 = shl i64 %.179.1.i284, %lsr.iv6.i270
  %.183.1.i286 = or i64 %.183.i280, %.181.1.i285
  %lsr.iv.next7.i289 = add i64 %lsr.iv6.i270, 16
  %lsr.iv.next86 = add i64 %lsr.iv85, -2
  %lsr.iv.next88 = add i64 %lsr.iv87, 2
  %niter.ncmp.1.i291 = icmp eq i64 %lsr.iv.next86, 0
  br i1 %niter.ncmp.1.i291, label %B192.loopexit.unr-lcssa.i292, label %B76.i268
B192.loopexit.unr-lcssa.i292:                     ; preds = %B76.i268
  %143 = and i64 %.252, 1
  %144 = icmp eq i64 %143, 0
  br i1 %144, label %B192.i306, label %B76.epil.preheader.i294
B76.epil.preheader.i294:                          ; preds = %B192.loopexit.unr-lcssa.i292, %B76.preheader.i265
  %value.3.0109.epil.init.i295 = phi i64 [ 0, %B76.preheader.i265 ], [ %.183.1.i286, %B192.loopexit.unr-lcssa.i292 ]
  %.148.epil.i297 = add nsw i64 %.1276, %37
  %.162.epil.i298 = icmp slt i64 %.148.epil.i297, 0
  %.163.epil.i299 = select i1 %.162.epil.i298, i64 %arg.raw.5.0, i64 0
  %145 = getelementptr i8, ptr %arg.raw.4, i64 %.148.epil.i297
  %.177.epil.i300 = getelementptr i8, ptr %145, i64 %.163.epil.i299
  %.178.epil.i301 = load i8, ptr %.177.epil.i300, align 1
  %.179.epil.i302 = zext i8 %.178.epil.i301 to i64
  %.181.epil.i304 = shl i64 %.179.epil.i302, %.180.epil.i303
  %.183.epil.i305 = or i64 %.181.epil.i304, %value.3.0109.epil.init.i295
  br label %B192.i306
B192.i306:                                        ; preds = %B76.epil.preheader.i294, %B192.loopexit.unr-lcssa.i292, %B190
  %value.3.0.lcssa.i307 = phi i64 [ 0, %B190 ], [ %.183.1.i286, %B192.loopexit.unr-lcssa.i292 ], [ %.183.epil.i305, %B76.epil.preheader.i294 ]
  %146 = icmp slt i64 %.252, 8
  %.196.i = icmp ne i64 %.1331, 0
  %or.cond.i = and i1 %146, %.196.i
  br i1 %or.cond.i, label %B208.i310, label %B972.endif
B208.i310:                                        ; preds = %B192.i306
  %.211.i311 = add nsw i64 %.1276, %.252
  %.228.inv.i312 = icmp sgt i64 %.211.i311, 0
  %.229.i313 = select i1 %.228.inv.i312, i64 0, i64 %arg.raw.5.0
  %147 = getelementptr i8, ptr %arg.raw.4, i64 %.211.i311
  %148 = getelementptr i8, ptr %147, i64 -1
  %.243.i314 = getelementptr i8, ptr %148, i64 %.229.i313
  %.244.i315 = load i8, ptr %.243.i314, align 1
  %.248.i316 = icmp slt i8 %.244.i315, 0
  %.256.i320 = select i1 %.248.i316, i64 %.254.neg.i319, i64 0
  %spec.select368 = add i64 %.256.i320, %value.3.0.lcssa.i307
  br label %B972.endif
common.ret:                                       ; preds = %B912.endif, %B740.endif.endif.if.if, %B480.endif, %B1062, %_ZN8rovbrush12orchestrator4loop5texts9number_ofB3v31B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dEx5ArrayIhLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit
  %common.ret.op = phi i32 [ 0, %B1062 ], [ 0, %B912.endif ], [ %.1148.us, %B740.endif.endif.if.if ], [ %.78.i, %_ZN8rovbrush12orchestrator4loop5texts9number_ofB3v31B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dEx5ArrayIhLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE.exit ], [ 0, %B480.endif ]
  ret i32 %common.ret.op
B1062.loopexit413.unr-lcssa:                      ; preds = %B190.us
  %149 = and i64 %.382, 1
  %lcmp.mod428.not = icmp eq i64 %149, 0
  br i1 %lcmp.mod428.not, label %B1062, label %B190.us.epil.preheader
B190.us.epil.preheader:                           ; preds = %B1062.loopexit413.unr-lcssa, %B190.us.preheader
  %.471680692.us.epil.init = phi i64 [ 0, %B190.us.preheader ], [ %unroll_iter430, %B1062.loopexit413.unr-lcssa ]
  %.627.us.epil = add nsw i64 %.471680692.us.epil.init, %.593.1
  %.641.us.epil = icmp slt i64 %.627.us.epil, 0
  %.642.us.epil = select i1 %.641.us.epil, i64 %arg.raw32.5.0, i64 0
  %150 = getelementptr float, ptr %arg.raw32.4, i64 %.627.us.epil
  %.656.us.epil = getelementptr float, ptr %150, i64 %.642.us.epil
  %.657.us.epil = load float, ptr %.656.us.epil, align 4
  %.660.us.epil = add nsw i64 %.471680692.us.epil.init, %.197
  %.676.us.epil = icmp slt i64 %.660.us.epil, 0
  %.677.us.epil = select i1 %.676.us.epil, i64 %arg.z.5.0, i64 0
  %151 = getelementptr double, ptr %arg.z.4, i64 %.660.us.epil
  %.691.us.epil = getelementptr double, ptr %151, i64 %.677.us.epil
  %.692.us.epil = fpext float %.657.us.epil to double
  store double %.692.us.epil, ptr %.691.us.epil, align 8
  br label %B1062
B1062.loopexit418.unr-lcssa:                      ; preds = %B190.us721.us
  %lcmp.mod.not = icmp eq i64 %xtraiter, 0
  br i1 %lcmp.mod.not, label %B1062, label %B190.us721.us.epil.preheader
B190.us721.us.epil.preheader:                     ; preds = %B1062.loopexit418.unr-lcssa, %B190.us721.us.preheader.B190.us721.us.epil.preheader_crit_edge
  %.pre-phi = phi i64 [ %.pre, %B190.us721.us.preheader.B190.us721.us.epil.preheader_crit_edge ], [ %12, %B1062.loopexit418.unr-lcssa ]
  %.471680692.us723.us.epil.init = phi i64 [ 0, %B190.us721.us.preheader.B190.us721.us.epil.preheader_crit_edge ], [ %unroll_iter, %B1062.loopexit418.unr-lcssa ]
  %152 = add nsw i64 %.471680692.us723.us.epil.init, %.197
  br label %B190.us721.us.epil
B190.us721.us.epil:                               ; preds = %B190.us721.us.epil, %B190.us721.us.epil.preheader
  %lsr.iv503 = phi i64 [ %lsr.iv.next504, %B190.us721.us.epil ], [ %xtraiter, %B190.us721.us.epil.preheader ]
  %lsr.iv500 = phi i64 [ %lsr.iv.next501, %B190.us721.us.epil ], [ %152, %B190.us721.us.epil.preheader ]
  %.920.us.us.epil = icmp slt i64 %lsr.iv500, 0
  %153 = select i1 %.920.us.us.epil, i64 %.pre-phi, i64 0
  %scevgep499 = getelementptr i8, ptr %arg.whole.4, i64 %153
  %154 = shl i64 %lsr.iv500, 3
  %scevgep502 = getelementptr i8, ptr %scevgep499, i64 %154
  store i64 0, ptr %scevgep502, align 8
  %lsr.iv.next501 = add i64 %lsr.iv500, 1
  %lsr.iv.next504 = add nsw i64 %lsr.iv503, -1
  %epil.iter.cmp.not = icmp eq i64 %lsr.iv.next504, 0
  br i1 %epil.iter.cmp.not, label %B1062, label %B190.us721.us.epil
B1062:                                            ; preds = %B952.us, %B652.endif.us, %B560.endif.us, %B190.us721.us.epil, %B520.us, %B190.us.us, %B972.endif, %B1062.loopexit418.unr-lcssa, %B190.us.epil.preheader, %B1062.loopexit413.unr-lcssa, %B0.endif
  store i64 -1, ptr %retptr, align 8
  br label %common.ret
B480.endif:                                       ; preds = %B390.endif.endif.us
  %.795 = add nsw i64 %.471680692.us702, %.197
  store i64 %.795, ptr %retptr, align 8
  br label %common.ret
B740.endif.endif.if.if:                           ; preds = %B740.endif.endif.us
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
B912.endif:                                       ; preds = %B740.endif.endif.endif.us
  store i64 %.1202, ptr %retptr, align 8
  br label %common.ret
B972.endif:                                       ; preds = %B208.i310, %B192.i306
  %value.4.0.i309 = phi i64 [ %value.3.0.lcssa.i307, %B192.i306 ], [ %spec.select368, %B208.i310 ]
  %.478 = add nuw nsw i64 %.471680692, 1
  %.1362 = add nsw i64 %.471680692, %.197
  %.1378 = icmp slt i64 %.1362, 0
  %.1379 = select i1 %.1378, i64 %arg.whole.5.0, i64 0
  %155 = getelementptr i64, ptr %arg.whole.4, i64 %.1362
  %.1393 = getelementptr i64, ptr %155, i64 %.1379
  store i64 %value.4.0.i309, ptr %.1393, align 8
  %lsr.iv.next445 = add i64 %lsr.iv444, %.252
  %exitcond814.not = icmp eq i64 %.382, %.478
  br i1 %exitcond814.not, label %B1062, label %B190
}
define linkonce_odr noundef i32 @f72(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.turns.0, ptr readnone %arg.turns.1, i64 %arg.turns.2, i64 %arg.turns.3, ptr readonly %arg.turns.4, i64 %arg.turns.5.0, i64 %arg.turns.5.1, i64 %arg.turns.6.0, i64 %arg.turns.6.1, i64 %arg.first, i64 %arg.last, ptr readnone %arg.moves.0, ptr readnone %arg.moves.1, i64 %arg.moves.2, i64 %arg.moves.3, ptr readonly %arg.moves.4, i64 %arg.moves.5.0, i64 %arg.moves.5.1, i64 %arg.moves.6.0, i64 %arg.moves.6.1, i64 %arg.moved, ptr readnone %arg.z.0, ptr readnone %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, ptr readnone %arg.coefficients.0, ptr readnone %arg.coefficients.1, i64 %arg.coefficients.2, i64 %arg.coefficients.3, ptr readonly %arg.coefficients.4, i64 %arg.coefficients.5.0, i64 %arg.coefficients.6.0, ptr readnone %arg.components.0, ptr readnone %arg.components.1, i64 %arg.components.2, i64 %arg.components.3, ptr readonly %arg.components.4, i64 %arg.components.5.0, i64 %arg.components.5.1, i64 %arg.components.6.0, i64 %arg.components.6.1, ptr readnone %arg.control.0, ptr readnone %arg.control.1, i64 %arg.control.2, i64 %arg.control.3, ptr writeonly %arg.control.4, i64 %arg.control.5.0, i64 %arg.control.6.0, i64 %arg.base, i64 %arg.varying, i64 %arg.numerator, i64 %arg.denominator, double %arg.stop) {
B0.endif:
  %.159 = sub i64 %arg.last, %arg.first
  %.2051565.not = icmp slt i64 %.159, 1
  br i1 %.2051565.not, label %common.ret, label %B54.lr.ph
B54.lr.ph:                                        ; preds = %B0.endif
  %const = bitcast i64 1099511627776 to i64
  %.1761 = sitofp i64 %arg.denominator to double
  %0 = shl i64 %arg.z.5.0, 3
  br label %B54
B54:                                              ; preds = %B1880, %B54.lr.ph
  %length.4.01574 = phi double [ 0.000000e+00, %B54.lr.ph ], [ %length.3.2, %B1880 ]
  %time.3.01573 = phi double [ 0.000000e+00, %B54.lr.ph ], [ %time.2.2, %B1880 ]
  %ticks.2.01572 = phi i64 [ -1, %B54.lr.ph ], [ %ticks.3.2, %B1880 ]
  %start.2.01571 = phi i64 [ -1, %B54.lr.ph ], [ %start.3.2, %B1880 ]
  %moved.2.01570 = phi i64 [ %arg.moved, %B54.lr.ph ], [ %moved.3.2, %B1880 ]
  %.20415171569 = phi i64 [ %.159, %B54.lr.ph ], [ %.214, %B1880 ]
  %.21115281568 = phi i64 [ %arg.first, %B54.lr.ph ], [ %.218, %B1880 ]
  %.214 = add nsw i64 %.20415171569, -1
  %.218 = add i64 %.21115281568, 1
  %.281 = icmp slt i64 %.21115281568, 0
  %.282 = select i1 %.281, i64 %arg.turns.5.0, i64 0
  %.283 = add i64 %.282, %.21115281568
  %.303 = mul i64 %.283, %arg.turns.5.1
  %.307 = getelementptr i64, ptr %arg.turns.4, i64 %.303
  %.308 = load i64, ptr %.307, align 8
  %.310 = icmp slt i64 %moved.2.01570, %.308
  br i1 %.310, label %B94.preheader, label %B376
B94.preheader:                                    ; preds = %B54
  br label %B94
B94:                                              ; preds = %B94.preheader, %B328
  %moved.4.1 = phi i64 [ %.792, %B328 ], [ %moved.2.01570, %B94.preheader ]
  %.346 = icmp slt i64 %moved.4.1, 0
  %.347 = select i1 %.346, i64 %arg.moves.5.0, i64 0
  %.348 = add i64 %.347, %moved.4.1
  %.368 = mul i64 %.348, %arg.moves.5.1
  %1 = getelementptr i64, ptr %arg.moves.4, i64 %.368
  %.372 = getelementptr i8, ptr %1, i64 16
  %.373 = load i64, ptr %.372, align 8
  %.378 = icmp slt i64 %.373, 0
  br i1 %.378, label %B136, label %B212
B136:                                             ; preds = %B94
  %sunkaddr = shl i64 %.368, 3
  %sunkaddr201 = getelementptr i8, ptr %arg.moves.4, i64 %sunkaddr
  %.436 = load i64, ptr %sunkaddr201, align 8
  %.450 = icmp slt i64 %.436, 0
  %.451 = select i1 %.450, i64 %arg.z.5.0, i64 0
  %2 = getelementptr double, ptr %arg.z.4, i64 %.436
  %.465 = getelementptr double, ptr %2, i64 %.451
  %.466 = load double, ptr %.465, align 8
  br label %B328
B212:                                             ; preds = %B94
  %.582 = getelementptr double, ptr %arg.coefficients.4, i64 %.373
  %.583 = load double, ptr %.582, align 8
  %sunkaddr202 = shl i64 %.368, 3
  %sunkaddr203 = getelementptr i8, ptr %arg.moves.4, i64 %sunkaddr202
  %.638 = load i64, ptr %sunkaddr203, align 8
  %.652 = icmp slt i64 %.638, 0
  %.653 = select i1 %.652, i64 %arg.z.5.0, i64 0
  %3 = getelementptr double, ptr %arg.z.4, i64 %.638
  %.667 = getelementptr double, ptr %3, i64 %.653
  %.668 = load double, ptr %.667, align 8
  %.669 = fmul double %.583, %.668
  %.702 = getelementptr i8, ptr %.582, i64 8
  %.703 = load double, ptr %.702, align 8
  %.704 = fadd double %.669, %.703
  br label %B328
B328:                                             ; preds = %B212, %B136
  %sunkaddr204.pre-phi = phi i64 [ %sunkaddr202, %B212 ], [ %sunkaddr, %B136 ]
  %.704.sink = phi double [ %.704, %B212 ], [ %.466, %B136 ]
  %sunkaddr205 = getelementptr i8, ptr %arg.moves.4, i64 %sunkaddr204.pre-phi
  %sunkaddr206 = getelementptr i8, ptr %sunkaddr205, i64 8
  %.759 = load i64, ptr %sunkaddr206, align 8
  %.773 = icmp slt i64 %.759, 0
  %.774 = select i1 %.773, i64 %arg.z.5.0, i64 0
  %4 = getelementptr double, ptr %arg.z.4, i64 %.759
  %.788 = getelementptr double, ptr %4, i64 %.774
  store double %.704.sink, ptr %.788, align 8
  %.792 = add nsw i64 %moved.4.1, 1
  %sunkaddr59 = mul i64 %.303, 8
  %sunkaddr62 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr59
  %.851 = load i64, ptr %sunkaddr62, align 8
  %.852 = icmp slt i64 %.792, %.851
  br i1 %.852, label %B94, label %B376
B376:                                             ; preds = %B328, %B54
  %moved.3.2 = phi i64 [ %moved.2.01570, %B54 ], [ %.792, %B328 ]
  %sunkaddr63 = mul i64 %.303, 8
  %sunkaddr65 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr63
  %sunkaddr66 = getelementptr i8, ptr %sunkaddr65, i64 128
  %.915 = load i64, ptr %sunkaddr66, align 8
  %sunkaddr68 = mul i64 %.303, 8
  %sunkaddr69 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr68
  %sunkaddr71 = getelementptr i8, ptr %sunkaddr69, i64 104
  %.970 = load i64, ptr %sunkaddr71, align 8
  %sunkaddr72 = mul i64 %.303, 8
  %sunkaddr74 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr72
  %sunkaddr75 = getelementptr i8, ptr %sunkaddr74, i64 8
  %.1031 = load i64, ptr %sunkaddr75, align 8
  %.1032.not = icmp eq i64 %.1031, 0
  br i1 %.1032.not, label %B768, label %B474
B474:                                             ; preds = %B376
  %sunkaddr77 = mul i64 %.303, 8
  %sunkaddr78 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr77
  %sunkaddr80 = getelementptr i8, ptr %sunkaddr78, i64 16
  %.1143 = load i64, ptr %sunkaddr80, align 8
  %sunkaddr81 = mul i64 %.303, 8
  %sunkaddr83 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr81
  %sunkaddr84 = getelementptr i8, ptr %sunkaddr83, i64 24
  %.1198 = load i64, ptr %sunkaddr84, align 8
  %sunkaddr86 = mul i64 %.303, 8
  %sunkaddr87 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr86
  %sunkaddr89 = getelementptr i8, ptr %sunkaddr87, i64 32
  %.1253 = load i64, ptr %sunkaddr89, align 8
  %sunkaddr90 = mul i64 %.303, 8
  %sunkaddr92 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr90
  %sunkaddr93 = getelementptr i8, ptr %sunkaddr92, i64 40
  %.1308 = load i64, ptr %sunkaddr93, align 8
  %.23.i = icmp eq i64 %.915, 2
  br i1 %.23.i, label %B16.endif.i, label %B54.i
B54.i:                                            ; preds = %B474
  %.71.i = icmp slt i64 %.1031, 0
  br i1 %.71.i, label %B66.endif.i, label %B122.endif.i
B16.endif.i:                                      ; preds = %B474
  %.9.i.i = inttoptr i64 %.1031 to ptr
  %.10.i.i = inttoptr i64 %.970 to ptr
  %.11.i.i = inttoptr i64 %.1143 to ptr
  %.12.i.i = inttoptr i64 %.1253 to ptr
  %.13.i.i = tail call i32 %.9.i.i(ptr %.10.i.i, ptr %.11.i.i, i64 %.1198, ptr %.12.i.i)
  br label %B474.endif
B66.endif.i:                                      ; preds = %B54.i
  %.74.i = sub i64 0, %.1031
  %.78.i = shl nsw i64 %.1308, 3
  %.80.i = add nsw i64 %.78.i, %.1253
  %.11.i1.i = inttoptr i64 %.74.i to ptr
  %.12.i2.i = inttoptr i64 %.970 to ptr
  %.13.i3.i = inttoptr i64 %.1143 to ptr
  %.14.i.i = inttoptr i64 %.80.i to ptr
  %.15.i.i = inttoptr i64 %.1253 to ptr
  %.16.i.i = tail call i32 %.11.i1.i(ptr %.12.i2.i, ptr %.13.i3.i, i64 %.1198, ptr %.14.i.i, ptr %.15.i.i, i64 %.1308)
  br label %B474.endif
B122.endif.i:                                     ; preds = %B54.i
  %.10.i4.i = inttoptr i64 %.1031 to ptr
  %.11.i5.i = inttoptr i64 %.970 to ptr
  %.12.i6.i = inttoptr i64 %.1143 to ptr
  %.13.i7.i = inttoptr i64 %.1253 to ptr
  %.14.i8.i = tail call i32 %.10.i4.i(ptr %.11.i5.i, ptr %.12.i6.i, i64 %.1198, ptr %.13.i7.i, i64 %.1308)
  br label %B474.endif
common.ret:                                       ; preds = %B1880, %B1782, %B1528, %B1194, %B676, %B0.endif
  %.sink = phi i64 [ 2, %B676 ], [ 3, %B1782 ], [ 2, %B1528 ], [ 2, %B1194 ], [ 0, %B0.endif ], [ 0, %B1880 ]
  store i64 %.sink, ptr %retptr, align 8
  ret i32 0
B676:                                             ; preds = %B474.endif
  %.1410 = mul nsw i64 %.21115281568, 3
  %.1442 = getelementptr i8, ptr %arg.control.4, i64 88
  store i64 %.1410, ptr %.1442, align 8
  %.1473 = getelementptr i8, ptr %arg.control.4, i64 24
  %.1474 = sext i32 %.14.i8.sink.i to i64
  store i64 %.1474, ptr %.1473, align 8
  br label %common.ret
B768:                                             ; preds = %B474.endif, %B376
  %sunkaddr95 = mul i64 %.303, 8
  %sunkaddr96 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr95
  %sunkaddr98 = getelementptr i8, ptr %sunkaddr96, i64 112
  %.1538 = load i64, ptr %sunkaddr98, align 8
  %.1540.not = icmp eq i64 %.1538, %start.2.01571
  %sunkaddr99 = mul i64 %.303, 8
  %sunkaddr101 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr99
  %sunkaddr102 = getelementptr i8, ptr %sunkaddr101, i64 120
  %.1618 = load i64, ptr %sunkaddr102, align 8
  %.1620.not = icmp eq i64 %.1618, %ticks.2.01572
  %or.cond = select i1 %.1540.not, i1 %.1620.not, i1 false
  br i1 %or.cond, label %B998, label %B844
B844:                                             ; preds = %B768
  %.1756 = add nsw i64 %.1538, %arg.base
  %.1758 = mul nsw i64 %.1756, %arg.numerator
  %.1760 = sitofp i64 %.1758 to double
  %.1765 = fdiv double %.1760, %.1761
  %.1774 = add nsw i64 %.1618, %arg.varying
  %.1776 = mul nsw i64 %.1774, %arg.numerator
  %.1778 = sitofp i64 %.1776 to double
  %.1783 = fdiv double %.1778, %.1761
  %.1787 = fadd double %.1765, %.1783
  %.1789 = fcmp ogt double %.1787, %arg.stop
  br i1 %.1789, label %B966, label %B998
B966:                                             ; preds = %B844
  %.12.i = fsub double %arg.stop, %.1765
  %.20.i = fadd double %.1765, %.12.i
  %.22.i = fcmp ogt double %.20.i, %arg.stop
  br i1 %.22.i, label %B32.i.preheader, label %B998
B32.i.preheader:                                  ; preds = %B966
  br label %B32.i
B32.i:                                            ; preds = %B32.i.preheader, %B32.i
  %length.2.0.i = phi double [ %.25.i, %B32.i ], [ %.12.i, %B32.i.preheader ]
  %.25.i = fmul double %length.2.0.i, 0x3FEFFFFFFFFFFFFE
  %.31.i = fadd double %.1765, %.25.i
  %.33.i = fcmp ogt double %.31.i, %arg.stop
  br i1 %.33.i, label %B32.i, label %B998
B998:                                             ; preds = %B32.i, %B966, %B844, %B768
  %start.3.2 = phi i64 [ %start.2.01571, %B768 ], [ %.1538, %B844 ], [ %.1538, %B966 ], [ %.1538, %B32.i ]
  %ticks.3.2 = phi i64 [ %ticks.2.01572, %B768 ], [ %.1618, %B844 ], [ %.1618, %B966 ], [ %.1618, %B32.i ]
  %time.2.2 = phi double [ %time.3.01573, %B768 ], [ %.1765, %B844 ], [ %.1765, %B966 ], [ %.1765, %B32.i ]
  %length.3.2 = phi double [ %length.4.01574, %B768 ], [ %.1783, %B844 ], [ %.12.i, %B966 ], [ %.25.i, %B32.i ]
  %.1845.not = icmp eq i64 %.915, 2
  br i1 %.1845.not, label %B1070.endif, label %B54.endif.i
B54.endif.i:                                      ; preds = %B998
  %sunkaddr104 = mul i64 %.303, 8
  %sunkaddr105 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr104
  %sunkaddr107 = getelementptr i8, ptr %sunkaddr105, i64 144
  %.1901 = load i64, ptr %sunkaddr107, align 8
  %.1928 = icmp slt i64 %.1901, 0
  %.1929 = select i1 %.1928, i64 %arg.components.5.0, i64 0
  %.1930 = add i64 %.1929, %.1901
  %.1950 = mul i64 %.1930, %arg.components.5.1
  %5 = getelementptr i64, ptr %arg.components.4, i64 %.1950
  %.1954 = getelementptr i8, ptr %5, i64 24
  %.1955 = load i64, ptr %.1954, align 8
  %sunkaddr108 = mul i64 %.303, 8
  %sunkaddr110 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr108
  %sunkaddr111 = getelementptr i8, ptr %sunkaddr110, i64 96
  %.201361 = load i64, ptr %sunkaddr111, align 8
  %sunkaddr113 = mul i64 %.303, 8
  %sunkaddr114 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr113
  %sunkaddr116 = getelementptr i8, ptr %sunkaddr114, i64 136
  %.206863 = load i64, ptr %sunkaddr116, align 8
  %6 = inttoptr i64 %.201361 to ptr
  %.12.i2.i70 = inttoptr i64 %.1955 to ptr
  %.13.i.i71 = add i64 %.1955, 1
  %.14.i.i72 = inttoptr i64 %.13.i.i71 to ptr
  %.15.i.i73 = add i64 %.1955, 2
  %.16.i.i74 = inttoptr i64 %.15.i.i73 to ptr
  %.17.i.i = add i64 %.1955, 8
  %.18.i.i = inttoptr i64 %.17.i.i to ptr
  store i8 0, ptr %.12.i2.i70, align 1
  store i8 0, ptr %.14.i.i72, align 1
  store i8 0, ptr %.16.i.i74, align 1
  %.22.i.i = trunc i64 %.206863 to i32
  %.23.i.i = inttoptr i64 %.970 to ptr
  %.24.i.i = tail call i32 %6(ptr %.23.i.i, double %time.2.2, double %length.3.2, i32 %.22.i.i, ptr nonnull %.12.i2.i70, ptr nonnull %.14.i.i72, ptr nonnull %.16.i.i74, ptr %.18.i.i)
  %.7.i9.i = icmp ugt i32 %.24.i.i, 1
  br i1 %.7.i9.i, label %B1194.split.loop.exit127, label %B124.endif.i
B124.endif.i:                                     ; preds = %B54.endif.i
  %7 = inttoptr i64 %.13.i.i71 to ptr
  %.6.i.i = load i8, ptr %7, align 1
  %.175.not.i = icmp eq i8 %.6.i.i, 0
  %const_mat = add i64 %const, 1
  br i1 %.175.not.i, label %B182.endif.i, label %B1194
B182.endif.i:                                     ; preds = %B124.endif.i
  %8 = inttoptr i64 %.15.i.i73 to ptr
  %.6.i4.i = load i8, ptr %8, align 1
  %.209.not.i = icmp eq i8 %.6.i4.i, 0
  %const_mat56 = add i64 %const, 2
  br i1 %.209.not.i, label %B240.endif.i, label %B1194
B240.endif.i:                                     ; preds = %B182.endif.i
  %9 = inttoptr i64 %.1955 to ptr
  %.6.i7.i = load i8, ptr %9, align 1
  %.244.not.i = icmp eq i8 %.6.i7.i, 0
  br i1 %.244.not.i, label %B1286.thread, label %B1194
B1194.split.loop.exit127:                         ; preds = %B1070.endif, %B54.endif.i
  %.2074.0.in143 = phi i32 [ %.12.i.i68, %B1070.endif ], [ %.24.i.i, %B54.endif.i ]
  %.2074.0.le = sext i32 %.2074.0.in143 to i64
  br label %B1194
B1194:                                            ; preds = %B240.endif.i, %B182.endif.i, %B124.endif.i, %B1194.split.loop.exit127
  %.2074.0114 = phi i64 [ %.2074.0.le, %B1194.split.loop.exit127 ], [ %const, %B240.endif.i ], [ %const_mat, %B124.endif.i ], [ %const_mat56, %B182.endif.i ]
  %.2175 = mul nsw i64 %.21115281568, 3
  %.2178 = add nsw i64 %.2175, 1
  %.2207 = getelementptr i8, ptr %arg.control.4, i64 88
  store i64 %.2178, ptr %.2207, align 8
  %.2238 = getelementptr i8, ptr %arg.control.4, i64 24
  store i64 %.2074.0114, ptr %.2238, align 8
  br label %common.ret
B1286:                                            ; preds = %B1070.endif
  %sunkaddr117 = mul i64 %.303, 8
  %sunkaddr119 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr117
  %sunkaddr120 = getelementptr i8, ptr %sunkaddr119, i64 48
  %.2302 = load i64, ptr %sunkaddr120, align 8
  %.2303.not = icmp eq i64 %.2302, 0
  br i1 %.2303.not, label %B1880, label %B16.endif.i100
B1286.thread:                                     ; preds = %B240.endif.i
  %sunkaddr122 = mul i64 %.303, 8
  %sunkaddr123 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr122
  %sunkaddr125 = getelementptr i8, ptr %sunkaddr123, i64 48
  %.2302148 = load i64, ptr %sunkaddr125, align 8
  %.2303.not149 = icmp eq i64 %.2302148, 0
  br i1 %.2303.not149, label %B1880, label %B54.i81
B54.i81:                                          ; preds = %B1286.thread
  %sunkaddr126 = mul i64 %.303, 8
  %sunkaddr128 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr126
  %sunkaddr129 = getelementptr i8, ptr %sunkaddr128, i64 56
  %.2414153 = load i64, ptr %sunkaddr129, align 8
  %sunkaddr131 = mul i64 %.303, 8
  %sunkaddr132 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr131
  %sunkaddr134 = getelementptr i8, ptr %sunkaddr132, i64 64
  %.2469155 = load i64, ptr %sunkaddr134, align 8
  %sunkaddr135 = mul i64 %.303, 8
  %sunkaddr136 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr135
  %sunkaddr137 = getelementptr i8, ptr %sunkaddr136, i64 72
  %.2524157 = load i64, ptr %sunkaddr137, align 8
  %sunkaddr138 = mul i64 %.303, 8
  %sunkaddr139 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr138
  %sunkaddr140 = getelementptr i8, ptr %sunkaddr139, i64 80
  %.2579159 = load i64, ptr %sunkaddr140, align 8
  %.71.i82 = icmp slt i64 %.2302148, 0
  br i1 %.71.i82, label %B66.endif.i90, label %B122.endif.i83
B16.endif.i100:                                   ; preds = %B1286
  %10 = inttoptr i64 %.970 to ptr
  %sunkaddr141 = mul i64 %.303, 8
  %sunkaddr142 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr141
  %sunkaddr143 = getelementptr i8, ptr %sunkaddr142, i64 56
  %.2414 = load i64, ptr %sunkaddr143, align 8
  %sunkaddr144 = mul i64 %.303, 8
  %sunkaddr145 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr144
  %sunkaddr146 = getelementptr i8, ptr %sunkaddr145, i64 64
  %.2469 = load i64, ptr %sunkaddr146, align 8
  %sunkaddr147 = mul i64 %.303, 8
  %sunkaddr148 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr147
  %sunkaddr149 = getelementptr i8, ptr %sunkaddr148, i64 72
  %.2524 = load i64, ptr %sunkaddr149, align 8
  %.9.i.i101 = inttoptr i64 %.2302 to ptr
  %.11.i.i103 = inttoptr i64 %.2414 to ptr
  %.12.i.i104 = inttoptr i64 %.2524 to ptr
  %.13.i.i105 = tail call i32 %.9.i.i101(ptr %10, ptr %.11.i.i103, i64 %.2469, ptr %.12.i.i104)
  br label %B1326.endif
B66.endif.i90:                                    ; preds = %B54.i81
  %11 = inttoptr i64 %.970 to ptr
  %.74.i91 = sub i64 0, %.2302148
  %.78.i92 = shl nsw i64 %.2579159, 3
  %.80.i93 = add nsw i64 %.78.i92, %.2524157
  %.11.i1.i94 = inttoptr i64 %.74.i91 to ptr
  %.13.i3.i96 = inttoptr i64 %.2414153 to ptr
  %.14.i.i97 = inttoptr i64 %.80.i93 to ptr
  %.15.i.i98 = inttoptr i64 %.2524157 to ptr
  %.16.i.i99 = tail call i32 %.11.i1.i94(ptr %11, ptr %.13.i3.i96, i64 %.2469155, ptr %.14.i.i97, ptr %.15.i.i98, i64 %.2579159)
  br label %B1326.endif
B122.endif.i83:                                   ; preds = %B54.i81
  %12 = inttoptr i64 %.970 to ptr
  %.10.i4.i84 = inttoptr i64 %.2302148 to ptr
  %.12.i6.i86 = inttoptr i64 %.2414153 to ptr
  %.13.i7.i87 = inttoptr i64 %.2524157 to ptr
  %.14.i8.i88 = tail call i32 %.10.i4.i84(ptr %12, ptr %.12.i6.i86, i64 %.2469155, ptr %.13.i7.i87, i64 %.2579159)
  br label %B1326.endif
B1528:                                            ; preds = %B1326.endif
  %.2681 = mul nsw i64 %.21115281568, 3
  %.2684 = add nsw i64 %.2681, 2
  %.2713 = getelementptr i8, ptr %arg.control.4, i64 88
  store i64 %.2684, ptr %.2713, align 8
  %.2744 = getelementptr i8, ptr %arg.control.4, i64 24
  %.2745 = sext i32 %.14.i8.sink.i89 to i64
  store i64 %.2745, ptr %.2744, align 8
  br label %common.ret
B1736:                                            ; preds = %B1620.endif, %B1738
  %.30061498 = phi i64 [ %.3013, %B1738 ], [ %.2809, %B1620.endif ]
  %.29991497 = phi i64 [ %.3009, %B1738 ], [ %..2919, %B1620.endif ]
  %.3000 = icmp sgt i64 %.29991497, 0
  br i1 %.3000, label %B1738, label %B1880
B1738:                                            ; preds = %B1736
  %.3009 = add nsw i64 %.29991497, -1
  %.3013 = add i64 %.30061498, 1
  %.3055 = icmp slt i64 %.30061498, 0
  %13 = select i1 %.3055, i64 %0, i64 0
  %scevgep = getelementptr i8, ptr %arg.z.4, i64 %13
  %14 = shl i64 %.30061498, 3
  %scevgep199 = getelementptr i8, ptr %scevgep, i64 %14
  %.3071 = load double, ptr %scevgep199, align 8
  %.3072 = fsub double %.3071, %.3071
  %.3073 = fcmp ord double %.3072, 0.000000e+00
  br i1 %.3073, label %B1736, label %B1782
B1782:                                            ; preds = %B1738
  %.3110 = mul nsw i64 %.21115281568, 3
  %.3113 = add nsw i64 %.3110, 2
  %.3142 = getelementptr i8, ptr %arg.control.4, i64 88
  store i64 %.3113, ptr %.3142, align 8
  %.3173 = getelementptr i8, ptr %arg.control.4, i64 32
  %15 = add i64 %.3013, -1
  store i64 %15, ptr %.3173, align 8
  br label %common.ret
B1880:                                            ; preds = %B1736, %B1286.thread, %B1286
  %.205 = icmp sgt i64 %.20415171569, 1
  br i1 %.205, label %B54, label %common.ret
B474.endif:                                       ; preds = %B122.endif.i, %B66.endif.i, %B16.endif.i
  %.14.i8.sink.i = phi i32 [ %.14.i8.i, %B122.endif.i ], [ %.16.i.i, %B66.endif.i ], [ %.13.i.i, %B16.endif.i ]
  %.7.i = icmp ugt i32 %.14.i8.sink.i, 1
  br i1 %.7.i, label %B676, label %B768
B1070.endif:                                      ; preds = %B998
  %sunkaddr150 = mul i64 %.303, 8
  %sunkaddr151 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr150
  %sunkaddr152 = getelementptr i8, ptr %sunkaddr151, i64 96
  %.201356 = load i64, ptr %sunkaddr152, align 8
  %sunkaddr153 = mul i64 %.303, 8
  %sunkaddr154 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr153
  %sunkaddr155 = getelementptr i8, ptr %sunkaddr154, i64 136
  %.206858 = load i64, ptr %sunkaddr155, align 8
  %16 = inttoptr i64 %.201356 to ptr
  %.10.i.i66 = trunc i64 %.206858 to i32
  %.11.i.i67 = inttoptr i64 %.970 to ptr
  %.12.i.i68 = tail call i32 %16(ptr %.11.i.i67, double %time.2.2, double %length.3.2, i32 %.10.i.i66)
  %.6.i = icmp ugt i32 %.12.i.i68, 1
  br i1 %.6.i, label %B1194.split.loop.exit127, label %B1286
B1326.endif:                                      ; preds = %B122.endif.i83, %B66.endif.i90, %B16.endif.i100
  %.14.i8.sink.i89 = phi i32 [ %.14.i8.i88, %B122.endif.i83 ], [ %.16.i.i99, %B66.endif.i90 ], [ %.13.i.i105, %B16.endif.i100 ]
  %.7.i108 = icmp ugt i32 %.14.i8.sink.i89, 1
  br i1 %.7.i108, label %B1528, label %B1620.endif
B1620.endif:                                      ; preds = %B1326.endif
  %sunkaddr156 = mul i64 %.303, 8
  %sunkaddr157 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr156
  %sunkaddr158 = getelementptr i8, ptr %sunkaddr157, i64 88
  %.2809 = load i64, ptr %sunkaddr158, align 8
  %sunkaddr159 = mul i64 %.303, 8
  %sunkaddr160 = getelementptr i8, ptr %arg.turns.4, i64 %sunkaddr159
  %sunkaddr161 = getelementptr i8, ptr %sunkaddr160, i64 80
  %.2919 = load i64, ptr %sunkaddr161, align 8
  %..2919 = tail call i64 @llvm.smax.i64(i64 %.2919, i64 0)
  br label %B1736
}
declare double @llvm.rint.f64(double)
define linkonce_odr noundef i32 @f73(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.table.0, ptr readnone %arg.table.1, i64 %arg.table.2, i64 %arg.table.3, ptr readonly %arg.table.4, i64 %arg.table.5.0, i64 %arg.table.6.0, i64 %arg.k, double %arg.begin, double %arg.end) {
B0.endif:
  %.38 = icmp slt i64 %arg.k, 0
  %.39 = select i1 %.38, i64 %arg.table.5.0, i64 0
  %0 = getelementptr double, ptr %arg.table.4, i64 %arg.k
  %.53 = getelementptr double, ptr %0, i64 %.39
  %.54 = load double, ptr %.53, align 8
  %.5.i = fptosi double %.54 to i64
  %.88.i70 = icmp sgt i64 %.5.i, 1
  br i1 %.88.i70, label %B68.else.if.preheader.i, label %B0.endif.endif
B98:                                              ; preds = %B0.endif.endif
  %.122 = add nsw i64 %arg.k, 2
  %.124 = add nsw i64 %.122, %low.4.1.i
  %.138 = icmp slt i64 %.124, 0
  %.139 = select i1 %.138, i64 %arg.table.5.0, i64 0
  %1 = getelementptr double, ptr %arg.table.4, i64 %.124
  %.153 = getelementptr double, ptr %1, i64 %.139
  %.154 = load double, ptr %.153, align 8
  %.156 = fcmp ult double %.154, %arg.end
  %.79.i7 = add i64 %.117, %arg.k
  %.80.i8 = add i64 %.79.i7, %.5.i
  %.108.i10 = icmp slt i64 %.80.i8, 0
  %.109.i11 = select i1 %.108.i10, i64 %arg.table.5.0, i64 0
  %2 = getelementptr double, ptr %arg.table.4, i64 %.80.i8
  %.123.i12 = getelementptr double, ptr %2, i64 %.109.i11
  %.124.i13 = load double, ptr %.123.i12, align 8
  br i1 %.156, label %B182.endif, label %B118.i
B118.i:                                           ; preds = %B98
  %.162 = fadd double %arg.begin, %arg.end
  %.167 = fmul double %.162, 5.000000e-01
  %.177.i = icmp slt i64 %.80.i8, -1
  %.178.i = select i1 %.177.i, i64 %arg.table.5.0, i64 0
  %3 = getelementptr i8, ptr %2, i64 8
  %.192.i = getelementptr double, ptr %3, i64 %.178.i
  %.193.i = load double, ptr %.192.i, align 8
  %.227.i = fsub double %.193.i, %.124.i13
  %.242.i = icmp slt i64 %.79.i7, 0
  %.243.i = select i1 %.242.i, i64 %arg.table.5.0, i64 0
  %4 = getelementptr double, ptr %arg.table.4, i64 %.79.i7
  %.257.i = getelementptr double, ptr %4, i64 %.243.i
  %.258.i = load double, ptr %.257.i, align 8
  %.260.i = fsub double %.167, %.258.i
  %.278.i = icmp slt i64 %.79.i7, -1
  %.279.i = select i1 %.278.i, i64 %arg.table.5.0, i64 0
  %5 = getelementptr i8, ptr %4, i64 8
  %.293.i = getelementptr double, ptr %5, i64 %.279.i
  %.294.i = load double, ptr %.293.i, align 8
  %.330.i = fsub double %.294.i, %.258.i
  %.334.i = fdiv double %.260.i, %.330.i
  %.335.i = fmul double %.227.i, %.334.i
  %.336.i = fadd double %.124.i13, %.335.i
  br label %common.ret
B280.preheader:                                   ; preds = %B182.endif
  %6 = shl i64 %arg.table.5.0, 3
  %7 = add i64 %6, 16
  %8 = add i64 %6, 24
  %9 = add i64 %.5.i, %arg.k
  %10 = add i64 %.5.i, -2
  %11 = shl i64 %arg.k, 3
  %scevgep26 = getelementptr i8, ptr %arg.table.4, i64 %11
  %12 = shl i64 %.5.i, 3
  %13 = add i64 %12, %11
  %scevgep31 = getelementptr i8, ptr %arg.table.4, i64 %13
  br label %B280
B280:                                             ; preds = %B432, %B280.preheader
  %lsr.iv22 = phi i64 [ %lsr.iv.next23, %B432 ], [ %low.4.1.i, %B280.preheader ]
  %left.2.0 = phi double [ %.336.i32, %B280.preheader ], [ %.387, %B432 ]
  %x.2.0 = phi double [ %arg.begin, %B280.preheader ], [ %.426, %B432 ]
  %total.3.0 = phi double [ 0.000000e+00, %B280.preheader ], [ %.433, %B432 ]
  %14 = add i64 %9, %lsr.iv22
  %15 = add i64 %14, 2
  %.371 = icmp slt i64 %15, 0
  %16 = select i1 %.371, i64 %7, i64 16
  %scevgep32 = getelementptr i8, ptr %scevgep31, i64 %16
  %17 = shl i64 %lsr.iv22, 3
  %scevgep33 = getelementptr i8, ptr %scevgep32, i64 %17
  %.387 = load double, ptr %scevgep33, align 8
  %.389 = fadd double %left.2.0, %.387
  %.392 = fmul double %.389, 5.000000e-01
  %18 = add i64 %arg.k, %lsr.iv22
  %19 = add i64 %18, 2
  %.410 = icmp slt i64 %19, 0
  %20 = select i1 %.410, i64 %7, i64 16
  %scevgep29 = getelementptr i8, ptr %scevgep26, i64 %20
  %21 = shl i64 %lsr.iv22, 3
  %scevgep30 = getelementptr i8, ptr %scevgep29, i64 %21
  %.426 = load double, ptr %scevgep30, align 8
  %.428 = fsub double %.426, %x.2.0
  %.431 = fmul double %.392, %.428
  %.433 = fadd double %total.3.0, %.431
  %exitcond.not = icmp eq i64 %10, %lsr.iv22
  br i1 %exitcond.not, label %B468.thread7, label %B432
B468.thread7:                                     ; preds = %B280
  %reass.add = shl i64 %.5.i, 1
  %.pre7310 = add i64 %reass.add, %arg.k
  %.108.i4411 = icmp slt i64 %.pre7310, 0
  %.109.i4512 = select i1 %.108.i4411, i64 %arg.table.5.0, i64 0
  %22 = getelementptr double, ptr %arg.table.4, i64 %.pre7310
  %.123.i4613 = getelementptr double, ptr %22, i64 %.109.i4512
  %.124.i4714 = load double, ptr %.123.i4613, align 8
  br label %B468.endif
B432:                                             ; preds = %B280
  %23 = add i64 %arg.k, %lsr.iv22
  %24 = add i64 %23, 3
  %.542 = icmp slt i64 %24, 0
  %25 = select i1 %.542, i64 %8, i64 24
  %scevgep27 = getelementptr i8, ptr %scevgep26, i64 %25
  %26 = shl i64 %lsr.iv22, 3
  %scevgep28 = getelementptr i8, ptr %scevgep27, i64 %26
  %.558 = load double, ptr %scevgep28, align 8
  %.560 = fcmp olt double %.558, %arg.end
  %lsr.iv.next23 = add i64 %lsr.iv22, 1
  br i1 %.560, label %B280, label %B468
B468:                                             ; preds = %B432
  %27 = add i64 %.5.i, -1
  %28 = add i64 %.5.i, %arg.k
  %29 = add i64 %28, %lsr.iv.next23
  %30 = add i64 %29, 1
  %31 = add i64 %.5.i, %arg.k
  %32 = add i64 %31, %lsr.iv.next23
  %33 = add i64 %32, 1
  %34 = icmp eq i64 %27, %lsr.iv.next23
  %.108.i44 = icmp slt i64 %30, 0
  %35 = select i1 %.108.i44, i64 %6, i64 0
  %36 = add i64 %35, 8
  %37 = shl i64 %.5.i, 3
  %38 = shl i64 %arg.k, 3
  %39 = add i64 %37, %38
  %scevgep = getelementptr i8, ptr %arg.table.4, i64 %39
  %scevgep24 = getelementptr i8, ptr %scevgep, i64 %36
  %40 = shl i64 %lsr.iv.next23, 3
  %scevgep25 = getelementptr i8, ptr %scevgep24, i64 %40
  %.124.i47 = load double, ptr %scevgep25, align 8
  br i1 %34, label %B468.endif, label %B468.B118.i48_crit_edge
B468.B118.i48_crit_edge:                          ; preds = %B468
  %41 = add i64 %arg.k, %lsr.iv.next23
  %42 = add i64 %41, 1
  br label %B118.i48
B118.i48:                                         ; preds = %B468.B118.i48_crit_edge, %B182.endif
  %.124.i4798 = phi double [ %.124.i13, %B182.endif ], [ %.124.i47, %B468.B118.i48_crit_edge ]
  %total.4.196 = phi double [ 0.000000e+00, %B182.endif ], [ %.433, %B468.B118.i48_crit_edge ]
  %x.3.194 = phi double [ %arg.begin, %B182.endif ], [ %.426, %B468.B118.i48_crit_edge ]
  %left.3.192 = phi double [ %.336.i32, %B182.endif ], [ %.387, %B468.B118.i48_crit_edge ]
  %.79.i41.pre-phi91 = phi i64 [ %.79.i7, %B182.endif ], [ %42, %B468.B118.i48_crit_edge ]
  %.80.i42.pre-phi90 = phi i64 [ %.80.i8, %B182.endif ], [ %33, %B468.B118.i48_crit_edge ]
  %43 = getelementptr double, ptr %arg.table.4, i64 %.80.i42.pre-phi90
  %.177.i49 = icmp slt i64 %.80.i42.pre-phi90, -1
  %.178.i50 = select i1 %.177.i49, i64 %arg.table.5.0, i64 0
  %44 = getelementptr i8, ptr %43, i64 8
  %.192.i51 = getelementptr double, ptr %44, i64 %.178.i50
  %.193.i52 = load double, ptr %.192.i51, align 8
  %.227.i53 = fsub double %.193.i52, %.124.i4798
  %.242.i54 = icmp slt i64 %.79.i41.pre-phi91, 0
  %.243.i55 = select i1 %.242.i54, i64 %arg.table.5.0, i64 0
  %45 = getelementptr double, ptr %arg.table.4, i64 %.79.i41.pre-phi91
  %.257.i56 = getelementptr double, ptr %45, i64 %.243.i55
  %.258.i57 = load double, ptr %.257.i56, align 8
  %.260.i58 = fsub double %arg.end, %.258.i57
  %.278.i59 = icmp slt i64 %.79.i41.pre-phi91, -1
  %.279.i60 = select i1 %.278.i59, i64 %arg.table.5.0, i64 0
  %46 = getelementptr i8, ptr %45, i64 8
  %.293.i61 = getelementptr double, ptr %46, i64 %.279.i60
  %.294.i62 = load double, ptr %.293.i61, align 8
  %.330.i63 = fsub double %.294.i62, %.258.i57
  %.334.i64 = fdiv double %.260.i58, %.330.i63
  %.335.i65 = fmul double %.227.i53, %.334.i64
  %.336.i66 = fadd double %.124.i4798, %.335.i65
  br label %B468.endif
B68.else.if.preheader.i:                          ; preds = %B0.endif
  %.78.i = add nsw i64 %.5.i, -1
  %.143.i = add nsw i64 %arg.k, 1
  br label %B68.else.if.i
B68.else.if.i:                                    ; preds = %B68.else.if.i, %B68.else.if.preheader.i
  %high.2.0.i = phi i64 [ %high.3.1.i, %B68.else.if.i ], [ %.78.i, %B68.else.if.preheader.i ]
  %low.2.0.i = phi i64 [ %low.3.1.i, %B68.else.if.i ], [ 0, %B68.else.if.preheader.i ]
  %.97.i = add nsw i64 %high.2.0.i, 1
  %.98.i = add i64 %.97.i, %low.2.0.i
  %.106.1.i = ashr i64 %.98.i, 1
  %.145.i = add nsw i64 %.143.i, %.106.1.i
  %.159.i = icmp slt i64 %.145.i, 0
  %.160.i = select i1 %.159.i, i64 %arg.table.5.0, i64 0
  %47 = getelementptr double, ptr %arg.table.4, i64 %.145.i
  %.174.i = getelementptr double, ptr %47, i64 %.160.i
  %.175.i = load double, ptr %.174.i, align 8
  %.177.i71 = fcmp ole double %.175.i, %arg.begin
  %.202.i = add nsw i64 %.106.1.i, -1
  %high.3.1.i = select i1 %.177.i71, i64 %high.2.0.i, i64 %.202.i
  %low.3.1.i = select i1 %.177.i71, i64 %.106.1.i, i64 %low.2.0.i
  %.219.i = icmp slt i64 %low.3.1.i, %high.3.1.i
  br i1 %.219.i, label %B68.else.if.i, label %B0.endif.endif
common.ret:                                       ; preds = %B468.endif, %B134.thread, %B118.i
  %storemerge = phi double [ %.654, %B468.endif ], [ %.336.i, %B118.i ], [ %.124.i79, %B134.thread ]
  store double %storemerge, ptr %retptr, align 8
  ret i32 0
B0.endif.endif:                                   ; preds = %B68.else.if.i, %B0.endif
  %low.4.1.i = phi i64 [ 0, %B0.endif ], [ %low.3.1.i, %B68.else.if.i ]
  %.117 = add nsw i64 %low.4.1.i, 1
  %.119 = icmp eq i64 %.117, %.5.i
  br i1 %.119, label %B134.thread, label %B98
B134.thread:                                      ; preds = %B0.endif.endif
  %reass.add21 = shl i64 %.5.i, 1
  %.80.i75 = add i64 %reass.add21, %arg.k
  %.108.i76 = icmp slt i64 %.80.i75, 0
  %.109.i77 = select i1 %.108.i76, i64 %arg.table.5.0, i64 0
  %48 = getelementptr double, ptr %arg.table.4, i64 %.80.i75
  %.123.i78 = getelementptr double, ptr %48, i64 %.109.i77
  %.124.i79 = load double, ptr %.123.i78, align 8
  br label %common.ret
B182.endif:                                       ; preds = %B98
  %.177.i15 = icmp slt i64 %.80.i8, -1
  %.178.i16 = select i1 %.177.i15, i64 %arg.table.5.0, i64 0
  %49 = getelementptr i8, ptr %2, i64 8
  %.192.i17 = getelementptr double, ptr %49, i64 %.178.i16
  %.193.i18 = load double, ptr %.192.i17, align 8
  %.227.i19 = fsub double %.193.i18, %.124.i13
  %.242.i20 = icmp slt i64 %.79.i7, 0
  %.243.i21 = select i1 %.242.i20, i64 %arg.table.5.0, i64 0
  %50 = getelementptr double, ptr %arg.table.4, i64 %.79.i7
  %.257.i22 = getelementptr double, ptr %50, i64 %.243.i21
  %.258.i23 = load double, ptr %.257.i22, align 8
  %.260.i24 = fsub double %arg.begin, %.258.i23
  %.278.i25 = icmp slt i64 %.79.i7, -1
  %.279.i26 = select i1 %.278.i25, i64 %arg.table.5.0, i64 0
  %51 = getelementptr i8, ptr %50, i64 8
  %.293.i27 = getelementptr double, ptr %51, i64 %.279.i26
  %.294.i28 = load double, ptr %.293.i27, align 8
  %.330.i29 = fsub double %.294.i28, %.258.i23
  %.334.i30 = fdiv double %.260.i24, %.330.i29
  %.335.i31 = fmul double %.227.i19, %.334.i30
  %.336.i32 = fadd double %.124.i13, %.335.i31
  %.264 = icmp slt i64 %.117, %.5.i
  %.337 = fcmp olt double %.154, %arg.end
  %or.cond = select i1 %.264, i1 %.337, i1 false
  br i1 %or.cond, label %B280.preheader, label %B118.i48
B468.endif:                                       ; preds = %B118.i48, %B468, %B468.thread7
  %total.4.197 = phi double [ %total.4.196, %B118.i48 ], [ %.433, %B468 ], [ %.433, %B468.thread7 ]
  %x.3.195 = phi double [ %x.3.194, %B118.i48 ], [ %.426, %B468 ], [ %.426, %B468.thread7 ]
  %left.3.193 = phi double [ %left.3.192, %B118.i48 ], [ %.387, %B468 ], [ %.387, %B468.thread7 ]
  %storemerge.i67 = phi double [ %.336.i66, %B118.i48 ], [ %.124.i47, %B468 ], [ %.124.i4714, %B468.thread7 ]
  %.630 = fadd double %left.3.193, %storemerge.i67
  %.633 = fmul double %.630, 5.000000e-01
  %.636 = fsub double %arg.end, %x.3.195
  %.639 = fmul double %.636, %.633
  %.641 = fadd double %total.4.197, %.639
  %.646 = fsub double %arg.end, %arg.begin
  %.654 = fdiv double %.641, %.646
  br label %common.ret
}
define linkonce_odr i32 @f74(ptr noalias writeonly %retptr, ptr noalias writeonly %excinfo, ptr readnone %arg.z.0, ptr readnone %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %arg.u, i64 %arg.g, i64 %arg.n, ptr readnone %arg.settings.0, ptr readnone %arg.settings.1, i64 %arg.settings.2, i64 %arg.settings.3, ptr readonly %arg.settings.4, i64 %arg.settings.5.0, i64 %arg.settings.6.0, i64 %arg.k, ptr readnone %arg.work.0, ptr readnone %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0) {
B0:
  %.88 = alloca i64, align 8
  %excinfo.1 = alloca ptr, align 8
  store ptr null, ptr %excinfo.1, align 8
  %.1769 = alloca i64, align 8
  %excinfo.4 = alloca ptr, align 8
  %.77 = getelementptr i8, ptr %arg.work.4, i64 8
  %.78 = load double, ptr %.77, align 8
  %.79 = fcmp ult double %.78, 0.000000e+00
  br i1 %.79, label %B80.endif, label %B38
B38:                                              ; preds = %B0
  store i64 0, ptr %.88, align 8
  %.98 = call i32 @f81(ptr nonnull %.88, ptr nonnull %excinfo.1, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %arg.u, i64 %arg.g, i64 %arg.n, ptr %arg.settings.0, ptr %arg.settings.1, i64 %arg.settings.2, i64 %arg.settings.3, ptr %arg.settings.4, i64 %arg.settings.5.0, i64 %arg.settings.6.0, i64 %arg.k, ptr %arg.work.0, ptr %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr nonnull %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0)
  %cond = icmp eq i32 %.98, 0
  br i1 %cond, label %B38.endif, label %B38.if.if
B554:                                             ; preds = %B446.endif.endif, %B80.endif
  %residual.2.0.lcssa = phi double [ 0.000000e+00, %B80.endif ], [ %residual.3.1801816, %B446.endif.endif ]
  %above.2.0.lcssa = phi double [ 0.000000e+00, %B80.endif ], [ %.625, %B446.endif.endif ]
  %below.2.0.lcssa = phi double [ 0.000000e+00, %B80.endif ], [ %.630, %B446.endif.endif ]
  %.707 = load double, ptr %arg.work.4, align 8
  %.708 = fadd double %.707, 1.000000e+00
  store double %.708, ptr %arg.work.4, align 8
  %sunkaddr = getelementptr i8, ptr %arg.work.4, i64 16
  store double %residual.2.0.lcssa, ptr %sunkaddr, align 8
  %.784 = icmp slt i64 %arg.k, 0
  %.785 = select i1 %.784, i64 %arg.settings.5.0, i64 0
  %0 = getelementptr double, ptr %arg.settings.4, i64 %arg.k
  %.799 = getelementptr double, ptr %0, i64 %.785
  %.800 = load double, ptr %.799, align 8
  %.802 = fcmp ugt double %residual.2.0.lcssa, %.800
  br i1 %.802, label %B730, label %B640
common.ret:                                       ; preds = %B1252.if.if, %B1252.endif, %B1198.endif, %B38.if.if, %B38.endif, %B1062, %B782, %B640
  %common.ret.op = phi i32 [ 0, %B640 ], [ 0, %B782 ], [ 0, %B1062 ], [ 0, %B38.endif ], [ %.98, %B38.if.if ], [ %.1777, %B1252.if.if ], [ 0, %B1198.endif ], [ 0, %B1252.endif ]
  ret i32 %common.ret.op
B640:                                             ; preds = %B554
  %.865 = icmp slt i64 %arg.u, 2
  %.866 = select i1 %.865, i64 %arg.z.5.0, i64 0
  %1 = getelementptr double, ptr %arg.z.4, i64 %arg.u
  %2 = getelementptr i8, ptr %1, i64 -16
  %.880 = getelementptr double, ptr %2, i64 %.866
  store double %.708, ptr %.880, align 8
  %.900.inv = icmp sgt i64 %arg.u, 0
  %.901 = select i1 %.900.inv, i64 0, i64 %arg.z.5.0
  %3 = getelementptr i8, ptr %1, i64 -8
  %.915 = getelementptr double, ptr %3, i64 %.901
  store double %residual.2.0.lcssa, ptr %.915, align 8
  store double 0.000000e+00, ptr %arg.work.4, align 8
  store i64 0, ptr %retptr, align 8
  br label %common.ret
B730:                                             ; preds = %B554
  %.1000 = icmp slt i64 %arg.k, -1
  %.1001 = select i1 %.1000, i64 %arg.settings.5.0, i64 0
  %4 = getelementptr i8, ptr %0, i64 8
  %.1015 = getelementptr double, ptr %4, i64 %.1001
  %.1016 = load double, ptr %.1015, align 8
  %.1017 = fcmp ult double %.708, %.1016
  br i1 %.1017, label %B796, label %B782
B782:                                             ; preds = %B730
  store i64 2, ptr %retptr, align 8
  br label %common.ret
B796:                                             ; preds = %B730
  %.1060 = icmp slt i64 %arg.k, -2
  %.1061 = select i1 %.1060, i64 %arg.settings.5.0, i64 0
  %5 = getelementptr i8, ptr %0, i64 16
  %.1075 = getelementptr double, ptr %5, i64 %.1061
  %.1076 = load double, ptr %.1075, align 8
  %.1078 = fcmp oeq double %.1076, 0.000000e+00
  br i1 %.1078, label %B836, label %B1076.endif
B836:                                             ; preds = %B796
  %.1120 = fcmp oeq double %.708, 1.000000e+00
  %.1123 = fcmp oeq double %below.2.0.lcssa, 0.000000e+00
  %or.cond = select i1 %.1120, i1 true, i1 %.1123
  br i1 %or.cond, label %B924.endif, label %B886.endif
B974:                                             ; preds = %B974.preheader.new, %B974
  %.1299854856 = phi i64 [ 0, %B974.preheader.new ], [ %.1306.1, %B974 ]
  %6 = add i64 %arg.u, %.1299854856
  %.1346 = icmp slt i64 %6, 0
  %7 = select i1 %.1346, i64 %59, i64 0
  %scevgep15 = getelementptr i8, ptr %scevgep, i64 %7
  %8 = shl i64 %.1299854856, 3
  %scevgep16 = getelementptr i8, ptr %scevgep15, i64 %8
  %.1362 = load double, ptr %scevgep16, align 8
  %sunkaddr22 = getelementptr i8, ptr %arg.work.4, i64 32
  %.1392 = load double, ptr %sunkaddr22, align 8
  %sunkaddr23 = mul i64 %.1299854856, 8
  %sunkaddr24 = getelementptr i8, ptr %arg.work.4, i64 %sunkaddr23
  %sunkaddr25 = getelementptr i8, ptr %sunkaddr24, i64 48
  %.1424 = load double, ptr %sunkaddr25, align 8
  %.1425 = fmul double %.1392, %.1424
  %.1426 = fadd double %.1362, %.1425
  store double %.1426, ptr %scevgep16, align 8
  %.1306.1 = add nuw i64 %.1299854856, 2
  %9 = add i64 %arg.u, %.1299854856
  %10 = add i64 %9, 1
  %.1346.1 = icmp slt i64 %10, 0
  %11 = select i1 %.1346.1, i64 %60, i64 8
  %scevgep12 = getelementptr i8, ptr %scevgep, i64 %11
  %12 = shl i64 %.1299854856, 3
  %scevgep1 = getelementptr i8, ptr %scevgep12, i64 %12
  %.1362.1 = load double, ptr %scevgep1, align 8
  %.1392.1 = load double, ptr %sunkaddr22, align 8
  %sunkaddr26 = mul i64 %.1299854856, 8
  %sunkaddr27 = getelementptr i8, ptr %arg.work.4, i64 %sunkaddr26
  %sunkaddr28 = getelementptr i8, ptr %sunkaddr27, i64 56
  %.1424.1 = load double, ptr %sunkaddr28, align 8
  %.1425.1 = fmul double %.1392.1, %.1424.1
  %.1426.1 = fadd double %.1362.1, %.1425.1
  store double %.1426.1, ptr %scevgep1, align 8
  %niter7.ncmp.1 = icmp eq i64 %unroll_iter6, %.1306.1
  br i1 %niter7.ncmp.1, label %B1062.loopexit.unr-lcssa, label %B974
B1062.loopexit.unr-lcssa:                         ; preds = %B974
  %13 = and i64 %arg.n, 1
  %lcmp.mod4.not = icmp eq i64 %13, 0
  br i1 %lcmp.mod4.not, label %B1062, label %B1062.loopexit.unr-lcssa.B974.epil.preheader_crit_edge
B1062.loopexit.unr-lcssa.B974.epil.preheader_crit_edge: ; preds = %B1062.loopexit.unr-lcssa
  %sunkaddr29 = getelementptr i8, ptr %arg.work.4, i64 32
  %.1392.epil.pre = load double, ptr %sunkaddr29, align 8
  br label %B974.epil.preheader
B974.epil.preheader:                              ; preds = %B974.preheader, %B1062.loopexit.unr-lcssa.B974.epil.preheader_crit_edge
  %.1392.epil = phi double [ %"$phi924.0.2.0", %B974.preheader ], [ %.1392.epil.pre, %B1062.loopexit.unr-lcssa.B974.epil.preheader_crit_edge ]
  %.1299854856.epil.init = phi i64 [ 0, %B974.preheader ], [ %unroll_iter6, %B1062.loopexit.unr-lcssa.B974.epil.preheader_crit_edge ]
  %.1332.epil = add nsw i64 %.1299854856.epil.init, %arg.u
  %.1346.epil = icmp slt i64 %.1332.epil, 0
  %.1347.epil = select i1 %.1346.epil, i64 %arg.z.5.0, i64 0
  %14 = getelementptr double, ptr %arg.z.4, i64 %.1332.epil
  %.1361.epil = getelementptr double, ptr %14, i64 %.1347.epil
  %.1362.epil = load double, ptr %.1361.epil, align 8
  %15 = getelementptr double, ptr %arg.work.4, i64 %.1299854856.epil.init
  %16 = getelementptr i8, ptr %15, i64 48
  %.1424.epil = load double, ptr %16, align 8
  %.1425.epil = fmul double %.1392.epil, %.1424.epil
  %.1426.epil = fadd double %.1362.epil, %.1425.epil
  store double %.1426.epil, ptr %.1361.epil, align 8
  br label %B1062
B1062:                                            ; preds = %B924.endif, %B974.epil.preheader, %B1062.loopexit.unr-lcssa
  store i64 1, ptr %retptr, align 8
  br label %common.ret
B1108:                                            ; preds = %B1108.preheader.new.new, %B1108
  %lsr.iv6 = phi i64 [ %78, %B1108.preheader.new.new ], [ %lsr.iv.next7, %B1108 ]
  %.1564847849 = phi i64 [ %.1571.1.1, %B1108 ], [ 0, %B1108.preheader.new.new ]
  %17 = add i64 %arg.u, %.1564847849
  %.1611 = icmp slt i64 %17, 0
  %18 = select i1 %.1611, i64 %67, i64 0
  %scevgep25 = getelementptr i8, ptr %scevgep17, i64 %18
  %19 = shl i64 %.1564847849, 3
  %scevgep26 = getelementptr i8, ptr %scevgep25, i64 %19
  %.1627 = load double, ptr %scevgep26, align 8
  %scevgep43 = getelementptr i8, ptr %scevgep40, i64 %19
  %scevgep44 = getelementptr i8, ptr %scevgep43, i64 -16
  %scevgep46 = getelementptr i8, ptr %scevgep43, i64 -24
  store double %.1627, ptr %scevgep46, align 8
  %20 = add i64 %arg.u, %.1564847849
  %21 = add i64 %20, 1
  %.1611.1 = icmp slt i64 %21, 0
  %22 = select i1 %.1611.1, i64 %72, i64 8
  %scevgep49 = getelementptr i8, ptr %scevgep17, i64 %22
  %23 = shl i64 %.1564847849, 3
  %scevgep10 = getelementptr i8, ptr %scevgep49, i64 %23
  %.1627.1 = load double, ptr %scevgep10, align 8
  store double %.1627.1, ptr %scevgep44, align 8
  %24 = add i64 %arg.u, %.1564847849
  %25 = add i64 %24, 2
  %.1611.18 = icmp slt i64 %25, 0
  %26 = select i1 %.1611.18, i64 %73, i64 16
  %scevgep47 = getelementptr i8, ptr %scevgep17, i64 %26
  %27 = shl i64 %.1564847849, 3
  %scevgep9 = getelementptr i8, ptr %scevgep47, i64 %27
  %.1627.19 = load double, ptr %scevgep9, align 8
  %scevgep11 = getelementptr i8, ptr %scevgep40, i64 %27
  %scevgep13 = getelementptr i8, ptr %scevgep11, i64 -8
  store double %.1627.19, ptr %scevgep13, align 8
  %.1571.1.1 = add i64 %.1564847849, 4
  %28 = add i64 %arg.u, %.1564847849
  %29 = add i64 %28, 3
  %.1611.1.1 = icmp slt i64 %29, 0
  %30 = select i1 %.1611.1.1, i64 %74, i64 24
  %scevgep38 = getelementptr i8, ptr %scevgep17, i64 %30
  %31 = shl i64 %.1564847849, 3
  %scevgep8 = getelementptr i8, ptr %scevgep38, i64 %31
  %.1627.1.1 = load double, ptr %scevgep8, align 8
  store double %.1627.1.1, ptr %scevgep43, align 8
  %lsr.iv.next7 = add i64 %lsr.iv6, 2
  %niter.ncmp.110 = icmp eq i64 %lsr.iv.next7, 0
  br i1 %niter.ncmp.110, label %B1146.loopexit.unr-lcssa.unr-lcssa, label %B1108
B1146.loopexit.unr-lcssa.unr-lcssa:               ; preds = %B1108
  %32 = and i64 %68, 2
  %lcmp.mod.not11.not = icmp eq i64 %32, 0
  br i1 %lcmp.mod.not11.not, label %B1108.epil.preheader2, label %B1146.loopexit.unr-lcssa
B1108.epil.preheader2:                            ; preds = %B1146.loopexit.unr-lcssa.unr-lcssa, %B1108.preheader.new
  %.1564847849.epil.init5 = phi i64 [ 0, %B1108.preheader.new ], [ %.1571.1.1, %B1146.loopexit.unr-lcssa.unr-lcssa ]
  %33 = add i64 %.1564847849.epil.init5, %arg.u
  %.1611.epil3 = icmp slt i64 %33, 0
  %34 = select i1 %.1611.epil3, i64 %67, i64 0
  %scevgep25.epil = getelementptr i8, ptr %scevgep17, i64 %34
  %35 = shl i64 %.1564847849.epil.init5, 3
  %scevgep26.epil = getelementptr i8, ptr %scevgep25.epil, i64 %35
  %.1627.epil4 = load double, ptr %scevgep26.epil, align 8
  %sunkaddr30 = mul i64 %.1564847849.epil.init5, 8
  %sunkaddr31 = getelementptr i8, ptr %66, i64 %sunkaddr30
  %sunkaddr32 = getelementptr i8, ptr %sunkaddr31, i64 48
  store double %.1627.epil4, ptr %sunkaddr32, align 8
  %36 = add i64 %33, 1
  %.1611.1.epil = icmp slt i64 %36, 0
  %37 = select i1 %.1611.1.epil, i64 %67, i64 0
  %scevgep18.epil = getelementptr i8, ptr %scevgep17, i64 %37
  %scevgep19.epil = getelementptr i8, ptr %scevgep18.epil, i64 %35
  %scevgep20.epil = getelementptr i8, ptr %scevgep19.epil, i64 8
  %.1627.1.epil = load double, ptr %scevgep20.epil, align 8
  %sunkaddr33 = mul i64 %.1564847849.epil.init5, 8
  %sunkaddr34 = getelementptr i8, ptr %66, i64 %sunkaddr33
  %sunkaddr35 = getelementptr i8, ptr %sunkaddr34, i64 56
  store double %.1627.1.epil, ptr %sunkaddr35, align 8
  br label %B1146.loopexit.unr-lcssa
B1146.loopexit.unr-lcssa:                         ; preds = %B1108.epil.preheader2, %B1146.loopexit.unr-lcssa.unr-lcssa
  %38 = and i64 %arg.n, 1
  %lcmp.mod.not = icmp eq i64 %38, 0
  br i1 %lcmp.mod.not, label %B1146.loopexit, label %B1108.epil.preheader
B1108.epil.preheader:                             ; preds = %B1108.preheader, %B1146.loopexit.unr-lcssa
  %.1564847849.epil.init = phi i64 [ 0, %B1108.preheader ], [ %unroll_iter, %B1146.loopexit.unr-lcssa ]
  %.1597.epil = add nsw i64 %.1564847849.epil.init, %arg.u
  %.1611.epil = icmp slt i64 %.1597.epil, 0
  %.1612.epil = select i1 %.1611.epil, i64 %arg.z.5.0, i64 0
  %39 = getelementptr double, ptr %arg.z.4, i64 %.1597.epil
  %.1626.epil = getelementptr double, ptr %39, i64 %.1612.epil
  %.1627.epil = load double, ptr %.1626.epil, align 8
  %40 = getelementptr double, ptr %62, i64 %.1564847849.epil.init
  store double %.1627.epil, ptr %40, align 8
  br label %B1146.loopexit
B1146.loopexit:                                   ; preds = %B1108.epil.preheader, %B1146.loopexit.unr-lcssa
  %.1696.pre = load double, ptr %arg.work.4, align 8
  br label %B1146
B1146:                                            ; preds = %B1076.endif, %B1146.loopexit
  %.1696 = phi double [ %.1696.pre, %B1146.loopexit ], [ %.708, %B1076.endif ]
  %.1697 = fcmp oeq double %.1696, 1.000000e+00
  %.1700 = fmul double %.173, 1.000000e-01
  %.1704 = fcmp ogt double %residual.2.0.lcssa, %.1700
  %or.cond826 = select i1 %.1697, i1 true, i1 %.1704
  br i1 %or.cond826, label %B1198.endif, label %B1252
B1252:                                            ; preds = %B1146
  store i64 0, ptr %.1769, align 8
  %.1777 = call i32 @f82(ptr nonnull %.1769, ptr nonnull %excinfo.4, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %arg.u, i64 %arg.n, ptr %arg.work.0, ptr %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr nonnull %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0)
  switch i32 %.1777, label %B1252.if.if [
    i32 -2, label %B1252.endif
    i32 0, label %B1252.endif
  ]
B38.endif:                                        ; preds = %B38
  %.108 = load i64, ptr %.88, align 8
  store i64 %.108, ptr %retptr, align 8
  br label %common.ret
B38.if.if:                                        ; preds = %B38
  %.106 = icmp sgt i32 %.98, 0
  %.99 = load ptr, ptr %excinfo.1, align 8
  %.107 = select i1 %.106, ptr %.99, ptr undef
  store ptr %.107, ptr %excinfo, align 8
  br label %common.ret
B80.endif:                                        ; preds = %B0
  %.172 = getelementptr i8, ptr %arg.work.4, i64 16
  %.173 = load double, ptr %.172, align 8
  %.228 = icmp sgt i64 %arg.n, 0
  br i1 %.228, label %B186.lr.ph, label %B554
B186.lr.ph:                                       ; preds = %B80.endif
  %41 = shl i64 %arg.k, 3
  %42 = getelementptr i8, ptr %arg.settings.4, i64 %41
  %scevgep29 = getelementptr i8, ptr %42, i64 24
  %43 = shl i64 %arg.u, 3
  %scevgep32 = getelementptr i8, ptr %arg.z.4, i64 %43
  %44 = shl i64 %arg.g, 3
  %scevgep35 = getelementptr i8, ptr %arg.z.4, i64 %44
  %45 = shl i64 %arg.z.5.0, 3
  %46 = shl i64 %arg.settings.5.0, 3
  %47 = add i64 %arg.k, 3
  br label %B186.endif
B186.endif:                                       ; preds = %B446.endif.endif, %B186.lr.ph
  %below.2.0841 = phi double [ 0.000000e+00, %B186.lr.ph ], [ %.630, %B446.endif.endif ]
  %above.2.0840 = phi double [ 0.000000e+00, %B186.lr.ph ], [ %.625, %B446.endif.endif ]
  %residual.2.0839 = phi double [ 0.000000e+00, %B186.lr.ph ], [ %residual.3.1801816, %B446.endif.endif ]
  %.276835837 = phi i64 [ 0, %B186.lr.ph ], [ %.283, %B446.endif.endif ]
  %.283 = add nuw nsw i64 %.276835837, 1
  %48 = add i64 %arg.g, %.276835837
  %.331 = icmp slt i64 %48, 0
  %49 = select i1 %.331, i64 %45, i64 0
  %scevgep36 = getelementptr i8, ptr %scevgep35, i64 %49
  %50 = shl i64 %.276835837, 3
  %scevgep37 = getelementptr i8, ptr %scevgep36, i64 %50
  %.347 = load double, ptr %scevgep37, align 8
  %51 = add i64 %arg.u, %.276835837
  %.364 = icmp slt i64 %51, 0
  %52 = select i1 %.364, i64 %45, i64 0
  %scevgep33 = getelementptr i8, ptr %scevgep32, i64 %52
  %53 = shl i64 %.276835837, 3
  %scevgep20 = getelementptr i8, ptr %scevgep33, i64 %53
  %.380 = load double, ptr %scevgep20, align 8
  %.381 = fsub double %.347, %.380
  %54 = add i64 %47, %.276835837
  %.402 = icmp slt i64 %54, 0
  %55 = select i1 %.402, i64 %46, i64 0
  %scevgep30 = getelementptr i8, ptr %scevgep29, i64 %55
  %56 = shl i64 %.276835837, 3
  %scevgep19 = getelementptr i8, ptr %scevgep30, i64 %56
  %.418 = load double, ptr %scevgep19, align 8
  %.452 = tail call double @llvm.fabs.f64(double %.347)
  %.10.i = fcmp ogt double %.452, %.418
  %.11.i = select i1 %.10.i, double %.452, double %.418
  %.485 = tail call double @llvm.fabs.f64(double %.381)
  %.490 = fdiv double %.485, %.11.i
  %.492 = fcmp ogt double %.490, %residual.2.0839
  br i1 %.492, label %B388.endif, label %B446.endif.endif
B388.endif:                                       ; preds = %B186.endif
  %.535 = uitofp i64 %.276835837 to double
  %sunkaddr36 = getelementptr i8, ptr %arg.work.4, i64 24
  store double %.535, ptr %sunkaddr36, align 8
  br label %B446.endif.endif
B446.endif.endif:                                 ; preds = %B388.endif, %B186.endif
  %residual.3.1801816 = phi double [ %residual.2.0839, %B186.endif ], [ %.490, %B388.endif ]
  %sunkaddr37 = mul i64 %.276835837, 8
  %sunkaddr38 = getelementptr i8, ptr %arg.work.4, i64 %sunkaddr37
  %sunkaddr39 = getelementptr i8, ptr %sunkaddr38, i64 48
  %.575803814 = load double, ptr %sunkaddr39, align 8
  %.577800.pn = fsub double %.381, %.575803814
  %.582817 = fdiv double %.577800.pn, %.11.i
  %.620 = fdiv double %.575803814, %.11.i
  %.623 = fmul double %.620, %.582817
  %.625 = fadd double %above.2.0840, %.623
  %.628 = fmul double %.582817, %.582817
  %.630 = fadd double %below.2.0841, %.628
  store double %.381, ptr %sunkaddr39, align 8
  %exitcond.not = icmp eq i64 %arg.n, %.283
  br i1 %exitcond.not, label %B554, label %B186.endif
B886.endif:                                       ; preds = %B836
  %.1161 = getelementptr i8, ptr %arg.work.4, i64 32
  %.1162 = load double, ptr %.1161, align 8
  %.1163 = fneg double %.1162
  %.1165 = fmul double %above.2.0.lcssa, %.1163
  %.1172 = fdiv double %.1165, %below.2.0.lcssa
  br label %B924.endif
B924.endif:                                       ; preds = %B886.endif, %B836
  %"$phi924.0.2.0" = phi double [ %.1172, %B886.endif ], [ 1.000000e+00, %B836 ]
  %.1207 = getelementptr i8, ptr %arg.work.4, i64 32
  store double %"$phi924.0.2.0", ptr %.1207, align 8
  %.1293855.not = icmp slt i64 %arg.n, 1
  br i1 %.1293855.not, label %B1062, label %B974.preheader
B974.preheader:                                   ; preds = %B924.endif
  %57 = icmp eq i64 %arg.n, 1
  br i1 %57, label %B974.epil.preheader, label %B974.preheader.new
B974.preheader.new:                               ; preds = %B974.preheader
  %const21 = bitcast i64 9223372036854775806 to i64
  %unroll_iter6 = and i64 %arg.n, %const21
  %58 = shl i64 %arg.u, 3
  %scevgep = getelementptr i8, ptr %arg.z.4, i64 %58
  %59 = shl i64 %arg.z.5.0, 3
  %60 = add i64 %59, 8
  br label %B974
B1076.endif:                                      ; preds = %B796
  %.1558848.not = icmp slt i64 %arg.n, 1
  br i1 %.1558848.not, label %B1146, label %B1108.preheader
B1108.preheader:                                  ; preds = %B1076.endif
  %61 = getelementptr double, ptr %arg.work.4, i64 %arg.n
  %62 = getelementptr i8, ptr %61, i64 48
  %63 = icmp eq i64 %arg.n, 1
  br i1 %63, label %B1108.epil.preheader, label %B1108.preheader.new
B1108.preheader.new:                              ; preds = %B1108.preheader
  %const = bitcast i64 9223372036854775806 to i64
  %unroll_iter = and i64 %arg.n, %const
  %64 = shl i64 %arg.u, 3
  %scevgep17 = getelementptr i8, ptr %arg.z.4, i64 %64
  %65 = shl i64 %arg.n, 3
  %66 = getelementptr i8, ptr %arg.work.4, i64 %65
  %67 = shl i64 %arg.z.5.0, 3
  %68 = add nsw i64 %arg.n, -2
  %69 = lshr i64 %68, 1
  %70 = icmp eq i64 %69, 0
  br i1 %70, label %B1108.epil.preheader2, label %B1108.preheader.new.new
B1108.preheader.new.new:                          ; preds = %B1108.preheader.new
  %71 = add nuw i64 %69, 1
  %scevgep40 = getelementptr i8, ptr %66, i64 72
  %72 = add i64 %67, 8
  %73 = add i64 %67, 16
  %74 = add i64 %67, 24
  %75 = lshr i64 %71, 1
  %76 = trunc i64 %75 to i62
  %77 = zext i62 %76 to i64
  %78 = mul nsw i64 %77, -2
  br label %B1108
B1198.endif:                                      ; preds = %B1146
  %sunkaddr40 = getelementptr i8, ptr %arg.work.4, i64 8
  store double 0.000000e+00, ptr %sunkaddr40, align 8
  %.65.i = add i64 %arg.k, 3
  %.78.i = icmp slt i64 %.65.i, 0
  %.79.i = select i1 %.78.i, i64 %arg.settings.5.0, i64 0
  %79 = getelementptr double, ptr %arg.settings.4, i64 %.65.i
  %.93.i = getelementptr double, ptr %79, i64 %.79.i
  %.94.i = load double, ptr %.93.i, align 8
  %.108.i = icmp slt i64 %arg.u, 0
  %.109.i = select i1 %.108.i, i64 %arg.z.5.0, i64 0
  %80 = getelementptr double, ptr %arg.z.4, i64 %arg.u
  %.123.i = getelementptr double, ptr %80, i64 %.109.i
  %.124.i = load double, ptr %.123.i, align 8
  %.125.i = tail call double @llvm.fabs.f64(double %.124.i)
  %.10.i.i = fcmp ogt double %.125.i, %.94.i
  %.11.i.i = select i1 %.10.i.i, double %.125.i, double %.94.i
  %.156.i = fmul double %.11.i.i, 0x3E50000000000000
  %.184.i = getelementptr i8, ptr %arg.work.4, i64 40
  store double %.156.i, ptr %.184.i, align 8
  %.215.i = load double, ptr %.123.i, align 8
  %.245.i = fadd double %.215.i, %.156.i
  store double %.245.i, ptr %.123.i, align 8
  store i64 1, ptr %retptr, align 8
  br label %common.ret
B1252.endif:                                      ; preds = %B1252, %B1252
  %.1787 = load i64, ptr %.1769, align 8
  store i64 %.1787, ptr %retptr, align 8
  br label %common.ret
B1252.if.if:                                      ; preds = %B1252
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
}
declare double @llvm.fabs.f64(double)
define linkonce_odr noundef i32 @f75(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.clock.0, ptr readnone %arg.clock.1, i64 %arg.clock.2, i64 %arg.clock.3, ptr %arg.clock.4, i64 %arg.clock.5.0, i64 %arg.clock.6.0, ptr readnone %arg.settings.0, ptr readnone %arg.settings.1, i64 %arg.settings.2, i64 %arg.settings.3, ptr readonly %arg.settings.4, i64 %arg.settings.5.0, i64 %arg.settings.6.0, i64 %arg.k, ptr readnone %arg.work.0, ptr readnone %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0) {
B184.endif.endif.endif:
  %.69 = load double, ptr %arg.work.4, align 8
  %.98 = getelementptr i8, ptr %arg.work.4, i64 8
  %.99 = load double, ptr %.98, align 8
  %.103 = fdiv double %.69, %.99
  %.104 = tail call double @sqrt(double %.103)
  %.10.i = fcmp olt double %.104, 1.000000e-10
  %.11.i = select i1 %.10.i, double 1.000000e-10, double %.104
  %.166 = getelementptr i8, ptr %arg.work.4, i64 16
  %.167 = load double, ptr %.166, align 8
  %.168 = fcmp ogt double %.167, 0.000000e+00
  %"$phi184.0.2.0" = select i1 %.168, double %.167, double %.11.i
  %.225 = icmp slt i64 %arg.k, 0
  %.226 = select i1 %.225, i64 %arg.settings.5.0, i64 0
  %0 = getelementptr double, ptr %arg.settings.4, i64 %arg.k
  %.240 = getelementptr double, ptr %0, i64 %.226
  %.241 = load double, ptr %.240, align 8
  %.257 = icmp slt i64 %arg.k, -1
  %.258 = select i1 %.257, i64 %arg.settings.5.0, i64 0
  %1 = getelementptr i8, ptr %0, i64 8
  %.272 = getelementptr double, ptr %1, i64 %.258
  %.273 = load double, ptr %.272, align 8
  %.289 = icmp slt i64 %arg.k, -2
  %.290 = select i1 %.289, i64 %arg.settings.5.0, i64 0
  %2 = getelementptr i8, ptr %0, i64 16
  %.304 = getelementptr double, ptr %2, i64 %.290
  %.305 = load double, ptr %.304, align 8
  %.306 = fadd double %.273, %.305
  %.307 = fneg double %.306
  %.309 = tail call double @llvm.pow.f64(double %.11.i, double %.307)
  %.310 = fmul double %.241, %.309
  %.343 = tail call double @llvm.pow.f64(double %"$phi184.0.2.0", double %.305)
  %.344 = fmul double %.343, %.310
  %.360 = icmp slt i64 %arg.k, -3
  %.361 = select i1 %.360, i64 %arg.settings.5.0, i64 0
  %3 = getelementptr i8, ptr %0, i64 24
  %.375 = getelementptr double, ptr %3, i64 %.361
  %.376 = load double, ptr %.375, align 8
  %.10.i1 = fcmp ogt double %.376, %.344
  %.11.i2 = select i1 %.10.i1, double %.376, double %.344
  %.422 = icmp slt i64 %arg.k, -4
  %.423 = select i1 %.422, i64 %arg.settings.5.0, i64 0
  %4 = getelementptr i8, ptr %0, i64 32
  %.437 = getelementptr double, ptr %4, i64 %.423
  %.438 = load double, ptr %.437, align 8
  %.10.i3 = fcmp olt double %.438, %.11.i2
  %.11.i4 = select i1 %.10.i3, double %.438, double %.11.i2
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %arg.work.4, i8 0, i64 16, i1 false)
  store double %.11.i, ptr %.166, align 8
  %.591 = load i64, ptr %arg.clock.4, align 8
  %.620 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.621 = load i64, ptr %.620, align 8
  %.622 = add nsw i64 %.621, %.591
  store i64 %.622, ptr %arg.clock.4, align 8
  %.683 = sitofp i64 %.621 to double
  %.684 = fmul double %.11.i4, %.683
  %.5.i = fptosi double %.684 to i64
  %.90.i = getelementptr i8, ptr %arg.clock.4, i64 16
  %.91.i = load i64, ptr %.90.i, align 8
  %.11.i.i = tail call i64 @llvm.smax.i64(i64 %.91.i, i64 %.5.i)
  %.150.i = getelementptr i8, ptr %arg.clock.4, i64 24
  %.151.i = load i64, ptr %.150.i, align 8
  %.11.i1.i = tail call i64 @llvm.smin.i64(i64 %.151.i, i64 %.11.i.i)
  %.211.i = getelementptr i8, ptr %arg.clock.4, i64 32
  %.212.i = load i64, ptr %.211.i, align 8
  %.243.i = sub nsw i64 %.212.i, %.622
  %.278.i = add nsw i64 %.11.i1.i, %.91.i
  %.280.not.i = icmp slt i64 %.243.i, %.278.i
  br i1 %.280.not.i, label %B244.i, label %common.ret
common.ret:                                       ; preds = %13, %B244.i, %B184.endif.endif.endif
  %storemerge.i = phi i64 [ %.11.i1.i, %B184.endif.endif.endif ], [ %.243.i, %B244.i ], [ %spec.select120.i, %13 ]
  %sunkaddr = getelementptr i8, ptr %arg.clock.4, i64 8
  store i64 %storemerge.i, ptr %sunkaddr, align 8
  store double %.11.i, ptr %retptr, align 8
  ret i32 0
B244.i:                                           ; preds = %B184.endif.endif.endif
  %.352.not.i.not = icmp sgt i64 %.243.i, %.151.i
  br i1 %.352.not.i.not, label %B294.else.if.i, label %common.ret
B294.else.if.i:                                   ; preds = %B244.i
  %5 = icmp ult i64 %.243.i, 4294967296
  br i1 %5, label %6, label %8
6:                                                ; preds = %B294.else.if.i
  %7 = lshr i64 %.243.i, 1
  br label %13
8:                                                ; preds = %B294.else.if.i
  %const = bitcast i64 -9223372036854775807 to i64
  %9 = sdiv i64 %.243.i, 2
  %10 = and i64 %.243.i, %const
  %11 = icmp eq i64 %10, %const
  %12 = sext i1 %11 to i64
  br label %13
13:                                               ; preds = %8, %6
  %14 = phi i64 [ %7, %6 ], [ %9, %8 ]
  %.390.i = phi i64 [ 0, %6 ], [ %12, %8 ]
  %spec.select120.i = add nsw i64 %.390.i, %14
  br label %common.ret
}
define linkonce_odr noundef i32 @f76(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.z.0, ptr readnone %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr readonly %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %arg.p, i64 %arg.n, ptr readnone %arg.clock.0, ptr readnone %arg.clock.1, i64 %arg.clock.2, i64 %arg.clock.3, ptr %arg.clock.4, i64 %arg.clock.5.0, i64 %arg.clock.6.0, ptr readnone %arg.settings.0, ptr readnone %arg.settings.1, i64 %arg.settings.2, i64 %arg.settings.3, ptr readonly %arg.settings.4, i64 %arg.settings.5.0, i64 %arg.settings.6.0, i64 %arg.k, ptr readnone %arg.work.0, ptr readnone %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0) {
B0.endif:
  %.142463.not = icmp slt i64 %arg.n, 1
  %0 = getelementptr double, ptr %arg.settings.4, i64 %arg.k
  %1 = add i64 %arg.k, 5
  %2 = add i64 %1, -5
  br i1 %.142463.not, label %B570.thread, label %B40.lr.ph
B570.thread:                                      ; preds = %B0.endif
  store double 0.000000e+00, ptr %arg.work.4, align 8
  %.507471 = icmp slt i64 %arg.k, -3
  %.508472 = select i1 %.507471, i64 %arg.settings.5.0, i64 0
  %3 = getelementptr i8, ptr %0, i64 24
  %.522473 = getelementptr double, ptr %3, i64 %.508472
  %factor.2.0478 = load double, ptr %.522473, align 8
  %.760479 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.761480 = load i64, ptr %.760479, align 8
  %.762481 = shl nsw i64 %.761480, 1
  %.791482 = getelementptr i8, ptr %arg.clock.4, i64 48
  store i64 0, ptr %.791482, align 8
  br label %B656.endif
B40.lr.ph:                                        ; preds = %B0.endif
  %.223 = add nsw i64 %arg.n, %arg.p
  %.370 = icmp slt i64 %arg.k, 0
  %4 = shl i64 %arg.p, 3
  %scevgep = getelementptr i8, ptr %arg.z.4, i64 %4
  %5 = shl i64 %.223, 3
  %scevgep11 = getelementptr i8, ptr %arg.z.4, i64 %5
  %6 = shl i64 %arg.k, 3
  %7 = getelementptr i8, ptr %arg.settings.4, i64 %6
  %scevgep14 = getelementptr i8, ptr %7, i64 40
  %8 = shl i64 %arg.settings.5.0, 3
  %9 = shl i64 %arg.z.5.0, 3
  %sunkaddr22 = select i1 %.370, i64 %8, i64 0
  %10 = add i64 %arg.k, 5
  br label %B40.endif
B288:                                             ; preds = %B40.endif
  %.436 = uitofp i64 %.148462464 to double
  %sunkaddr7 = getelementptr i8, ptr %arg.work.4, i64 8
  store double %.436, ptr %sunkaddr7, align 8
  br label %B314
B314:                                             ; preds = %B40.endif, %B288
  %eps.3.1 = phi double [ %.391, %B288 ], [ %eps.2.0466, %B40.endif ]
  %exitcond.not = icmp eq i64 %arg.n, %.155
  br i1 %exitcond.not, label %B316, label %B40.endif
B316:                                             ; preds = %B314
  store double %eps.3.1, ptr %arg.work.4, align 8
  %.507 = icmp slt i64 %arg.k, -3
  %.508 = select i1 %.507, i64 %arg.settings.5.0, i64 0
  %.528 = fcmp ogt double %eps.3.1, 0.000000e+00
  br i1 %.528, label %B380.endif.endif, label %B316.B570_crit_edge
B316.B570_crit_edge:                              ; preds = %B316
  %sunkaddr19 = shl i64 %.508, 3
  %sunkaddr20 = getelementptr i8, ptr %0, i64 %sunkaddr19
  %sunkaddr21 = getelementptr i8, ptr %sunkaddr20, i64 24
  %factor.2.0.pre = load double, ptr %sunkaddr21, align 8
  br label %B570
B570:                                             ; preds = %B380.endif.endif, %B316.B570_crit_edge
  %factor.2.0 = phi double [ %factor.2.0.pre, %B316.B570_crit_edge ], [ %.11.i6, %B380.endif.endif ]
  %.760 = getelementptr i8, ptr %arg.clock.4, i64 8
  %.761 = load i64, ptr %.760, align 8
  %.762 = shl nsw i64 %.761, 1
  %.791 = getelementptr i8, ptr %arg.clock.4, i64 48
  store i64 0, ptr %.791, align 8
  store i64 %.762, ptr %.760, align 8
  %.828 = fcmp ugt double %eps.3.1, 1.000000e+00
  br i1 %.828, label %B804, label %B656.endif
B804:                                             ; preds = %B570
  %.1017 = getelementptr i8, ptr %arg.clock.4, i64 16
  %.1018 = load i64, ptr %.1017, align 8
  %.1020.not = icmp sgt i64 %.762, %.1018
  br i1 %.1020.not, label %B852.endif.endif.endif, label %common.ret
common.ret:                                       ; preds = %B852.endif.endif.endif, %B656.endif.endif, %B804
  %.sink = phi i64 [ 1, %B852.endif.endif.endif ], [ 0, %B656.endif.endif ], [ 2, %B804 ]
  store i64 %.sink, ptr %retptr, align 8
  ret i32 0
B40.endif:                                        ; preds = %B314, %B40.lr.ph
  %eps.2.0466 = phi double [ 0.000000e+00, %B40.lr.ph ], [ %eps.3.1, %B314 ]
  %.148462464 = phi i64 [ 0, %B40.lr.ph ], [ %.155, %B314 ]
  %.155 = add nuw nsw i64 %.148462464, 1
  %11 = add i64 %10, %.148462464
  %.204 = icmp slt i64 %11, 0
  %12 = select i1 %.204, i64 %8, i64 0
  %scevgep15 = getelementptr i8, ptr %scevgep14, i64 %12
  %13 = shl i64 %.148462464, 3
  %scevgep16 = getelementptr i8, ptr %scevgep15, i64 %13
  %.220 = load double, ptr %scevgep16, align 8
  %14 = add i64 %.223, %.148462464
  %.239 = icmp slt i64 %14, 0
  %15 = select i1 %.239, i64 %9, i64 0
  %scevgep12 = getelementptr i8, ptr %scevgep11, i64 %15
  %16 = shl i64 %.148462464, 3
  %scevgep4 = getelementptr i8, ptr %scevgep12, i64 %16
  %.255 = load double, ptr %scevgep4, align 8
  %.256 = tail call double @llvm.fabs.f64(double %.255)
  %.10.i = fcmp ogt double %.256, %.220
  %.11.i = select i1 %.10.i, double %.256, double %.220
  %17 = add i64 %arg.p, %.148462464
  %.336 = icmp slt i64 %17, 0
  %18 = select i1 %.336, i64 %9, i64 0
  %scevgep9 = getelementptr i8, ptr %scevgep, i64 %18
  %19 = shl i64 %.148462464, 3
  %scevgep3 = getelementptr i8, ptr %scevgep9, i64 %19
  %.352 = load double, ptr %scevgep3, align 8
  %.353 = fsub double %.255, %.352
  %.354 = tail call double @llvm.fabs.f64(double %.353)
  %sunkaddr8 = getelementptr i8, ptr %0, i64 %sunkaddr22
  %.386 = load double, ptr %sunkaddr8, align 8
  %.387 = fmul double %.386, %.11.i
  %.391 = fdiv double %.354, %.387
  %.397 = fcmp ogt double %.391, %eps.2.0466
  br i1 %.397, label %B288, label %B314
B380.endif.endif:                                 ; preds = %B316
  %.545 = icmp slt i64 %arg.k, -1
  %.546 = select i1 %.545, i64 %arg.settings.5.0, i64 0
  %20 = getelementptr i8, ptr %0, i64 8
  %.560 = getelementptr double, ptr %20, i64 %.546
  %.561 = load double, ptr %.560, align 8
  %.577 = icmp slt i64 %arg.k, -4
  %.578 = select i1 %.577, i64 %arg.settings.5.0, i64 0
  %21 = getelementptr i8, ptr %0, i64 32
  %.592 = getelementptr double, ptr %21, i64 %.578
  %.593 = load double, ptr %.592, align 8
  %.597 = fdiv double -1.000000e+00, %.593
  %.599 = tail call double @llvm.pow.f64(double %eps.3.1, double %.597)
  %.600 = fmul double %.561, %.599
  %.616 = icmp slt i64 %2, -2
  %.617 = select i1 %.616, i64 %arg.settings.5.0, i64 0
  %22 = getelementptr i8, ptr %0, i64 16
  %.631 = getelementptr double, ptr %22, i64 %.617
  %.632 = load double, ptr %.631, align 8
  %.10.i2 = fcmp ogt double %.632, %.600
  %.11.i3 = select i1 %.10.i2, double %.632, double %.600
  %sunkaddr24 = shl i64 %.508, 3
  %sunkaddr25 = getelementptr i8, ptr %0, i64 %sunkaddr24
  %sunkaddr26 = getelementptr i8, ptr %sunkaddr25, i64 24
  %.694 = load double, ptr %sunkaddr26, align 8
  %.10.i5 = fcmp olt double %.694, %.11.i3
  %.11.i6 = select i1 %.10.i5, double %.694, double %.11.i3
  br label %B570
B656.endif:                                       ; preds = %B570, %B570.thread
  %.762486 = phi i64 [ %.762481, %B570.thread ], [ %.762, %B570 ]
  %.760485 = phi ptr [ %.760479, %B570.thread ], [ %.760, %B570 ]
  %factor.2.0484 = phi double [ %factor.2.0478, %B570.thread ], [ %factor.2.0, %B570 ]
  %.863 = load i64, ptr %arg.clock.4, align 8
  %.865 = add nsw i64 %.863, %.762486
  store i64 %.865, ptr %arg.clock.4, align 8
  %.898 = sitofp i64 %.762486 to double
  %.899 = fmul double %factor.2.0484, %.898
  %.5.i = fptosi double %.899 to i64
  %23 = icmp ult i64 %.5.i, 4294967296
  br i1 %23, label %24, label %26
B244.i:                                           ; preds = %31
  %.352.not.i.not = icmp sgt i64 %.243.i, %.151.i
  br i1 %.352.not.i.not, label %B294.else.if.i, label %B656.endif.endif
24:                                               ; preds = %B656.endif
  %25 = lshr i64 %.5.i, 1
  br label %31
26:                                               ; preds = %B656.endif
  %const = bitcast i64 -9223372036854775807 to i64
  %27 = sdiv i64 %.5.i, 2
  %28 = and i64 %.5.i, %const
  %29 = icmp eq i64 %28, %const
  %30 = sext i1 %29 to i64
  br label %31
31:                                               ; preds = %26, %24
  %32 = phi i64 [ %25, %24 ], [ %27, %26 ]
  %.41.i = phi i64 [ 0, %24 ], [ %30, %26 ]
  %spec.select.i = add nsw i64 %.41.i, %32
  %33 = shl nsw i64 %spec.select.i, 1
  %.90.i = getelementptr i8, ptr %arg.clock.4, i64 16
  %.91.i = load i64, ptr %.90.i, align 8
  %.11.i.i = tail call i64 @llvm.smax.i64(i64 %.91.i, i64 %33)
  %.150.i = getelementptr i8, ptr %arg.clock.4, i64 24
  %.151.i = load i64, ptr %.150.i, align 8
  %.11.i1.i = tail call i64 @llvm.smin.i64(i64 %.151.i, i64 %.11.i.i)
  %.211.i = getelementptr i8, ptr %arg.clock.4, i64 32
  %.212.i = load i64, ptr %.211.i, align 8
  %.243.i = sub nsw i64 %.212.i, %.865
  %.278.i = add nsw i64 %.11.i1.i, %.91.i
  %.280.not.i = icmp slt i64 %.243.i, %.278.i
  br i1 %.280.not.i, label %B244.i, label %B656.endif.endif
B294.else.if.i:                                   ; preds = %B244.i
  %34 = icmp ult i64 %.243.i, 4294967296
  br i1 %34, label %35, label %37
35:                                               ; preds = %B294.else.if.i
  %36 = lshr i64 %.243.i, 2
  br label %42
37:                                               ; preds = %B294.else.if.i
  %const5 = bitcast i64 -9223372036854775807 to i64
  %38 = sdiv i64 %.243.i, 4
  %const_mat6 = add i64 %const5, 2
  %39 = and i64 %.243.i, %const_mat6
  %const_mat = add i64 %const5, -1
  %40 = icmp ugt i64 %39, %const_mat
  %41 = sext i1 %40 to i64
  br label %42
42:                                               ; preds = %37, %35
  %43 = phi i64 [ %36, %35 ], [ %38, %37 ]
  %.390.i = phi i64 [ 0, %35 ], [ %41, %37 ]
  %spec.select120.i = add nsw i64 %.390.i, %43
  %44 = shl nsw i64 %spec.select120.i, 1
  br label %B656.endif.endif
B656.endif.endif:                                 ; preds = %42, %31, %B244.i
  %storemerge.i = phi i64 [ %.11.i1.i, %31 ], [ %.243.i, %B244.i ], [ %44, %42 ]
  store i64 %storemerge.i, ptr %.760485, align 8
  br label %common.ret
B852.endif.endif.endif:                           ; preds = %B804
  %.1060 = getelementptr i8, ptr %arg.work.4, i64 16
  %.1061 = load double, ptr %.1060, align 8
  %.1062 = fadd double %.1061, 1.000000e+00
  store double %.1062, ptr %.1060, align 8
  %.1097 = sitofp i64 %.762 to double
  %.1098 = fmul double %factor.2.0, %.1097
  %.5.i4 = fptosi double %.1098 to i64
  %.1167 = and i64 %.5.i4, -2
  %sunkaddr = getelementptr i8, ptr %arg.clock.4, i64 16
  %.1197 = load i64, ptr %sunkaddr, align 8
  %.11.i7 = tail call i64 @llvm.smax.i64(i64 %.1197, i64 %.1167)
  %sunkaddr9 = getelementptr i8, ptr %arg.clock.4, i64 8
  store i64 %.11.i7, ptr %sunkaddr9, align 8
  br label %common.ret
}
define linkonce_odr noundef i32 @f77(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, i64 %arg.fmi, i64 %arg.function, i64 %arg.instance, double %arg.time, double %arg.length, i64 %arg.final, i64 %arg.flags) {
B0:
  %.23 = icmp eq i64 %arg.fmi, 2
  br i1 %.23, label %B16.endif, label %B54.endif
common.ret:                                       ; preds = %B240.endif, %B182.endif, %B124.endif, %B16.endif, %B292
  %.68.sink = phi i64 [ %.68, %B16.endif ], [ %.253, %B292 ], [ %const_mat1, %B182.endif ], [ %const_mat, %B124.endif ], [ %const, %B240.endif ]
  store i64 %.68.sink, ptr %retptr, align 8
  ret i32 0
B292:                                             ; preds = %B240.endif, %B54.endif
  %.253 = sext i32 %.24.i to i64
  br label %common.ret
B16.endif:                                        ; preds = %B0
  %0 = inttoptr i64 %arg.function to ptr
  %.10.i = trunc i64 %arg.final to i32
  %.11.i = inttoptr i64 %arg.instance to ptr
  %.12.i = tail call i32 %0(ptr %.11.i, double %arg.time, double %arg.length, i32 %.10.i)
  %.68 = sext i32 %.12.i to i64
  br label %common.ret
B54.endif:                                        ; preds = %B0
  %1 = inttoptr i64 %arg.function to ptr
  %.12.i2 = inttoptr i64 %arg.flags to ptr
  %.13.i = add i64 %arg.flags, 1
  %.14.i = inttoptr i64 %.13.i to ptr
  %.15.i = add i64 %arg.flags, 2
  %.16.i = inttoptr i64 %.15.i to ptr
  %.17.i = add i64 %arg.flags, 8
  %.18.i = inttoptr i64 %.17.i to ptr
  store i8 0, ptr %.12.i2, align 1
  store i8 0, ptr %.14.i, align 1
  store i8 0, ptr %.16.i, align 1
  %.22.i = trunc i64 %arg.final to i32
  %.23.i = inttoptr i64 %arg.instance to ptr
  %.24.i = tail call i32 %1(ptr %.23.i, double %arg.time, double %arg.length, i32 %.22.i, ptr nonnull %.12.i2, ptr nonnull %.14.i, ptr nonnull %.16.i, ptr %.18.i)
  %.7.i9 = icmp ugt i32 %.24.i, 1
  br i1 %.7.i9, label %B292, label %B124.endif
B124.endif:                                       ; preds = %B54.endif
  %2 = inttoptr i64 %.13.i to ptr
  %const = bitcast i64 1099511627776 to i64
  %.6.i = load i8, ptr %2, align 1
  %.175.not = icmp eq i8 %.6.i, 0
  %const_mat = add i64 %const, 1
  br i1 %.175.not, label %B182.endif, label %common.ret
B182.endif:                                       ; preds = %B124.endif
  %3 = inttoptr i64 %.15.i to ptr
  %.6.i4 = load i8, ptr %3, align 1
  %.209.not = icmp eq i8 %.6.i4, 0
  %const_mat1 = add i64 %const, 2
  br i1 %.209.not, label %B240.endif, label %common.ret
B240.endif:                                       ; preds = %B182.endif
  %4 = inttoptr i64 %arg.flags to ptr
  %.6.i7 = load i8, ptr %4, align 1
  %.244.not = icmp eq i8 %.6.i7, 0
  br i1 %.244.not, label %B292, label %common.ret
}
define linkonce_odr noundef i32 @f78(ptr noalias writeonly %retptr, ptr noalias writeonly %excinfo, i64 %arg.seed, i64 %arg.stream, i64 %arg.counter) {
B0:
  %.16 = alloca [4 x i64], align 8
  %excinfo.1 = alloca ptr, align 8
  %.7 = and i64 %arg.counter, 4294967295
  %.8 = lshr i64 %arg.counter, 32
  %.10 = and i64 %arg.stream, 4294967295
  %.11 = lshr i64 %arg.stream, 32
  %.13 = and i64 %arg.seed, 4294967295
  %.14 = lshr i64 %arg.seed, 32
  %.20 = call i32 @f83(ptr nonnull %.16, ptr nonnull %excinfo.1, i64 %.7, i64 %.8, i64 %.10, i64 %.11, i64 %.13, i64 %.14)
  %cond = icmp eq i32 %.20, 0
  br i1 %cond, label %B0.endif, label %B0.if.if
common.ret:                                       ; preds = %B0.if.if, %B0.endif
  ret i32 %.20
B0.endif:                                         ; preds = %B0
  %.fca.3.gep = getelementptr inbounds i8, ptr %.16, i64 24
  %.fca.2.gep = getelementptr inbounds i8, ptr %.16, i64 16
  %.fca.1.gep = getelementptr inbounds i8, ptr %.16, i64 8
  %.30.fca.3.load = load i64, ptr %.fca.3.gep, align 8
  %.30.fca.2.load = load i64, ptr %.fca.2.gep, align 8
  %.30.fca.1.load = load i64, ptr %.fca.1.gep, align 8
  %.30.fca.0.load = load i64, ptr %.16, align 8
  %.46 = shl i64 %.30.fca.0.load, 21
  %.47 = ashr i64 %.30.fca.1.load, 11
  %.48 = or i64 %.46, %.47
  %.49 = add nsw i64 %.48, 1
  %.50 = sitofp i64 %.49 to double
  %.51 = fmul double %.50, 0x3CA0000000000000
  %.52 = shl i64 %.30.fca.2.load, 21
  %.53 = ashr i64 %.30.fca.3.load, 11
  %.54 = or i64 %.52, %.53
  %.55 = sitofp i64 %.54 to double
  %.56 = fmul double %.55, 0x3CA0000000000000
  %.57 = tail call double @llvm.log.f64(double %.51)
  %.58 = fmul double %.57, -2.000000e+00
  %.59 = tail call double @sqrt(double %.58)
  %.61 = fmul double %.56, 0x401921FB54442D18
  %.62 = tail call double @llvm.cos.f64(double %.61)
  %.63 = fmul double %.59, %.62
  store double %.63, ptr %retptr, align 8
  br label %common.ret
B0.if.if:                                         ; preds = %B0
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
}
define linkonce_odr noundef i32 @f79(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.control.0, ptr readnone %arg.control.1, i64 %arg.control.2, i64 %arg.control.3, ptr %arg.control.4, i64 %arg.control.5.0, i64 %arg.control.6.0, i64 %arg.tick) {
B0:
  %.41.i = getelementptr i8, ptr %arg.control.4, i64 120
  %.42.i = load i64, ptr %.41.i, align 8
  %.43.i = sub nsw i64 %arg.tick, %.42.i
  %.71.i = getelementptr i8, ptr %arg.control.4, i64 128
  %.72.i = load i64, ptr %.71.i, align 8
  %.73.i = mul nsw i64 %.43.i, %.72.i
  %.101.i = getelementptr i8, ptr %arg.control.4, i64 112
  %.102.i = load i64, ptr %.101.i, align 8
  %.130.i = getelementptr i8, ptr %arg.control.4, i64 136
  %.131.i = load i64, ptr %.130.i, align 8
  %.134.i = icmp eq i64 %.131.i, 0
  br i1 %.134.i, label %B0.endif.endif, label %B0.else.i
B0.else.i:                                        ; preds = %B0
  %.145.i = icmp ne i64 %.73.i, -9223372036854775808
  %.146.i = icmp ne i64 %.131.i, -1
  %.147.not.i = or i1 %.145.i, %.146.i
  br i1 %.147.not.i, label %B0.else.if.i, label %B0.endif.endif
B0.else.if.i:                                     ; preds = %B0.else.i
  %0 = or i64 %.131.i, %.73.i
  %1 = icmp ult i64 %0, 4294967296
  br i1 %1, label %2, label %9
2:                                                ; preds = %B0.else.if.i
  %3 = trunc i64 %.131.i to i32
  %4 = trunc i64 %.73.i to i32
  %5 = udiv i32 %4, %3
  %6 = urem i32 %4, %3
  %7 = zext i32 %5 to i64
  %8 = zext i32 %6 to i64
  br label %23
9:                                                ; preds = %B0.else.if.i
  %10 = or i64 %.73.i, %.131.i
  %11 = and i64 %10, -4294967296
  %12 = icmp eq i64 %11, 0
  br i1 %12, label %13, label %20
13:                                               ; preds = %9
  %14 = trunc i64 %.131.i to i32
  %15 = trunc i64 %.73.i to i32
  %16 = udiv i32 %15, %14
  %17 = urem i32 %15, %14
  %18 = zext i32 %16 to i64
  %19 = zext i32 %17 to i64
  br label %23
20:                                               ; preds = %9
  %21 = sdiv i64 %.73.i, %.131.i
  %22 = srem i64 %.73.i, %.131.i
  br label %23
23:                                               ; preds = %13, %20, %2
  %24 = phi i64 [ %7, %2 ], [ %18, %13 ], [ %21, %20 ]
  %25 = phi i64 [ %8, %2 ], [ %19, %13 ], [ %22, %20 ]
  %.152.i = xor i64 %25, %.131.i
  %.153.i = icmp slt i64 %.152.i, 0
  %.154.i = icmp ne i64 %25, 0
  %.155.i = and i1 %.154.i, %.153.i
  %.160.i = sext i1 %.155.i to i64
  %spec.select.i = add i64 %24, %.160.i
  br label %B0.endif.endif
B82:                                              ; preds = %B0.endif.endif
  %.97 = sub nsw i64 %.172.i, %.152.i15
  %.100 = icmp sgt i64 %.97, 20000000
  br i1 %.100, label %common.ret, label %B124.endif.endif.endif
common.ret:                                       ; preds = %B124.endif.endif.endif, %B1118, %B878, %B82
  %.sink = phi i64 [ 0, %B1118 ], [ 8, %B124.endif.endif.endif ], [ 8, %B82 ], [ 9, %B878 ]
  store i64 %.sink, ptr %retptr, align 8
  ret i32 0
B316:                                             ; preds = %B124.endif.endif.endif
  %26 = inttoptr i64 %.66.i6 to ptr
  %sunkaddr = getelementptr i8, ptr %arg.control.4, i64 96
  %.41.i1 = load i64, ptr %sunkaddr, align 8
  %.6.i.i = inttoptr i64 %.41.i1 to ptr
  %.8.i.i = tail call i32 %.6.i.i(i32 1, ptr %26)
  %sunkaddr2 = getelementptr i8, ptr %arg.control.4, i64 200
  %.121.i = load i64, ptr %sunkaddr2, align 8
  %.122.i = mul nsw i64 %.121.i, 1000000000
  %sunkaddr3 = getelementptr i8, ptr %arg.control.4, i64 208
  %.151.i = load i64, ptr %sunkaddr3, align 8
  %.152.i2 = add nsw i64 %.122.i, %.151.i
  br label %B346.endif
.loopexit:                                        ; preds = %B518.endif, %B346.endif
  %k.3.1 = phi i64 [ 0, %B346.endif ], [ %35, %B518.endif ]
  %27 = getelementptr i64, ptr %arg.control.4, i64 %k.3.1
  %28 = getelementptr i8, ptr %27, i64 240
  %.765 = load i64, ptr %28, align 8
  %.766 = add nsw i64 %.765, 1
  store i64 %.766, ptr %28, align 8
  %.825 = getelementptr i8, ptr %arg.control.4, i64 152
  %.826 = load i64, ptr %.825, align 8
  %.828 = icmp sgt i64 %.11.i, %.826
  br i1 %.828, label %B694, label %B786
B694:                                             ; preds = %.loopexit
  %29 = icmp slt i64 %.172.i, %.152.i15
  %sunkaddr4 = getelementptr i8, ptr %arg.control.4, i64 152
  store i64 %.11.i, ptr %sunkaddr4, align 8
  %.890 = getelementptr i8, ptr %arg.control.4, i64 160
  store i64 %arg.tick, ptr %.890, align 8
  br i1 %29, label %B740, label %B768
B740:                                             ; preds = %B694
  %.924 = getelementptr i8, ptr %arg.control.4, i64 184
  %.925 = load i64, ptr %.924, align 8
  br label %B768
B768:                                             ; preds = %B740, %B694
  %"$phi768.0.2.0" = phi i64 [ %.925, %B740 ], [ -1, %B694 ]
  %.962 = getelementptr i8, ptr %arg.control.4, i64 168
  store i64 %"$phi768.0.2.0", ptr %.962, align 8
  br label %B786
B786:                                             ; preds = %B768, %.loopexit
  %30 = icmp slt i64 %.172.i, %.152.i15
  %.997 = getelementptr i8, ptr %arg.control.4, i64 184
  %.998 = load i64, ptr %.997, align 8
  %.1031 = getelementptr i8, ptr %arg.control.4, i64 176
  store i64 %now.2.0, ptr %.1031, align 8
  %.1063 = getelementptr i8, ptr %arg.control.4, i64 192
  store i64 0, ptr %.1063, align 8
  store i64 -1, ptr %.997, align 8
  br i1 %30, label %B878, label %B1118
B878:                                             ; preds = %B786
  %.1127 = getelementptr i8, ptr %arg.control.4, i64 224
  %.1128 = load i64, ptr %.1127, align 8
  %.1129 = add nsw i64 %.1128, 1
  store i64 %.1129, ptr %.1127, align 8
  %.1178 = icmp slt i64 %.998, -51
  %.1179 = select i1 %.1178, i64 %arg.control.5.0, i64 0
  %31 = getelementptr i64, ptr %arg.control.4, i64 %.998
  %32 = getelementptr i8, ptr %31, i64 408
  %.1193 = getelementptr i64, ptr %32, i64 %.1179
  %.1194 = load i64, ptr %.1193, align 8
  %.1195 = add nsw i64 %.1194, 1
  store i64 %.1195, ptr %.1193, align 8
  %.1254 = getelementptr i8, ptr %arg.control.4, i64 144
  %.1255 = load i64, ptr %.1254, align 8
  switch i64 %.1255, label %B1118 [
    i64 1, label %common.ret
    i64 2, label %B1076
  ]
B1076:                                            ; preds = %B878
  %sunkaddr5 = getelementptr i8, ptr %arg.control.4, i64 112
  %.1325 = load i64, ptr %sunkaddr5, align 8
  %.1327 = add nsw i64 %.1325, %.11.i
  store i64 %.1327, ptr %sunkaddr5, align 8
  br label %B1118
B1118:                                            ; preds = %B1076, %B878, %B786
  br label %common.ret
B0.endif.endif:                                   ; preds = %23, %B0.else.i, %B0
  %quot.0.i = phi i64 [ 0, %B0 ], [ 0, %B0.else.i ], [ %spec.select.i, %23 ]
  %.172.i = add nsw i64 %quot.0.i, %.102.i
  %.40.i3 = getelementptr i8, ptr %arg.control.4, i64 96
  %.41.i4 = load i64, ptr %.40.i3, align 8
  %.64.i5 = ptrtoint ptr %arg.control.4 to i64
  %.66.i6 = add nsw i64 %.64.i5, 200
  %.6.i.i7 = inttoptr i64 %.41.i4 to ptr
  %.7.i.i8 = inttoptr i64 %.66.i6 to ptr
  %.8.i.i9 = tail call i32 %.6.i.i7(i32 1, ptr %.7.i.i8)
  %.120.i10 = getelementptr i8, ptr %arg.control.4, i64 200
  %.121.i11 = load i64, ptr %.120.i10, align 8
  %.122.i12 = mul nsw i64 %.121.i11, 1000000000
  %.150.i13 = getelementptr i8, ptr %arg.control.4, i64 208
  %.151.i14 = load i64, ptr %.150.i13, align 8
  %.152.i15 = add nsw i64 %.122.i12, %.151.i14
  %.87 = icmp slt i64 %.172.i, %.152.i15
  br i1 %.87, label %B346.endif, label %B82
B124.endif.endif.endif:                           ; preds = %B82
  %33 = inttoptr i64 %.66.i6 to ptr
  %.131 = sdiv i64 %.172.i, 1000000000
  %.132 = srem i64 %.172.i, 1000000000
  %.132.lobit = ashr i64 %.132, 63
  %.120.1 = add nsw i64 %.132.lobit, %.131
  %.175 = icmp slt i64 %.132, 0
  %.184 = add nsw i64 %.132, 1000000000
  %.164.1 = select i1 %.175, i64 %.184, i64 %.132
  %sunkaddr6 = getelementptr i8, ptr %arg.control.4, i64 200
  store i64 %.120.1, ptr %sunkaddr6, align 8
  %sunkaddr7 = getelementptr i8, ptr %arg.control.4, i64 208
  store i64 %.164.1, ptr %sunkaddr7, align 8
  %.282 = getelementptr i8, ptr %arg.control.4, i64 104
  %.283 = load i64, ptr %.282, align 8
  %.6.i = inttoptr i64 %.283 to ptr
  %.8.i = tail call i32 %.6.i(i32 1, i32 1, ptr %33, ptr null)
  %.335.not = icmp eq i32 %.8.i, 0
  br i1 %.335.not, label %B316, label %common.ret
B346.endif:                                       ; preds = %B0.endif.endif, %B316
  %now.2.0 = phi i64 [ %.152.i15, %B0.endif.endif ], [ %.152.i2, %B316 ]
  %.381 = sub nsw i64 %now.2.0, %.172.i
  %.11.i = tail call i64 @llvm.smax.i64(i64 %.381, i64 0)
  %.443 = getelementptr i8, ptr %arg.control.4, i64 216
  %.444 = load i64, ptr %.443, align 8
  %.445 = add nsw i64 %.444, 1
  store i64 %.445, ptr %.443, align 8
  %.504 = getelementptr i8, ptr %arg.control.4, i64 232
  %.505 = load i64, ptr %.504, align 8
  %.507 = add nsw i64 %.505, %.11.i
  store i64 %.507, ptr %.504, align 8
  %.554 = icmp sgt i64 %.381, 999
  br i1 %.554, label %B518.endif.preheader, label %.loopexit
B518.endif.preheader:                             ; preds = %B346.endif
  br label %B518.endif
B518.endif:                                       ; preds = %B518.endif.preheader, %B518.endif
  %lsr.iv = phi i64 [ %lsr.iv.next, %B518.endif ], [ 1, %B518.endif.preheader ]
  %edge.2.0 = phi i64 [ %"$phi570.0.2.1", %B518.endif ], [ 1000, %B518.endif.preheader ]
  %k.2.0 = phi i64 [ %35, %B518.endif ], [ 0, %B518.endif.preheader ]
  %34 = urem i64 %lsr.iv, 3
  %35 = add nuw nsw i64 %k.2.0, 1
  %36 = add i64 %k.2.0, 1
  %37 = sub nuw nsw i64 %36, %34
  %38 = trunc i64 %37 to i8
  %tmp16 = add nuw nsw i8 %38, 1
  %tmp = trunc i64 %k.2.0 to i8
  %.628 = icmp eq i8 %tmp, %tmp16
  %.679 = shl nsw i64 %edge.2.0, 1
  %.631 = mul nsw i64 %edge.2.0, 5
  %spec.select = ashr i64 %.631, 1
  %"$phi570.0.2.1" = select i1 %.628, i64 %spec.select, i64 %.679
  %.696 = icmp sge i64 %.11.i, %"$phi570.0.2.1"
  %.711 = icmp ult i64 %k.2.0, 18
  %or.cond = and i1 %.711, %.696
  %lsr.iv.next = add nuw nsw i64 %lsr.iv, 1
  br i1 %or.cond, label %B518.endif, label %.loopexit
}
declare i64 @llvm.smax.i64(i64, i64)
declare i64 @llvm.smin.i64(i64, i64)
define linkonce_odr noundef i32 @f83(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, i64 %arg.c0, i64 %arg.c1, i64 %arg.c2, i64 %arg.c3, i64 %arg.k0, i64 %arg.k1) {
B0.endif.endif:
  %const = bitcast i64 3449683968 to i64
  %.7.i = mul nsw i64 %arg.c0, 53841
  %.8.i = ashr i64 %.7.i, 16
  %.10.i = mul nsw i64 %arg.c0, 8019
  %const_mat16 = add i64 %const, 78839808
  %.11.i = mul i64 %arg.c0, %const_mat16
  %.12.i = and i64 %.11.i, 4294901760
  %.13.i = add nsw i64 %.12.i, %.10.i
  %.14.i = ashr i64 %.13.i, 32
  %.15.i = add nsw i64 %.14.i, %.8.i
  %const_mat26 = add i64 %const, 78847827
  %reass.mul.i = mul i64 %arg.c0, %const_mat26
  %.7.i15 = mul nsw i64 %arg.c2, 52638
  %.8.i16 = ashr i64 %.7.i15, 16
  %.10.i17 = mul nsw i64 %arg.c2, 36183
  %.11.i18 = mul i64 %arg.c2, %const
  %.12.i19 = and i64 %.11.i18, 4294836224
  %.13.i20 = add nsw i64 %.12.i19, %.10.i17
  %.14.i21 = ashr i64 %.13.i20, 32
  %.15.i22 = add nsw i64 %.14.i21, %.8.i16
  %const_mat6 = add i64 %const, 36183
  %reass.mul.i23 = mul i64 %arg.c2, %const_mat6
  %0 = xor i64 %arg.c1, %.15.i22
  %.258 = xor i64 %0, %arg.k0
  %1 = xor i64 %.15.i, %arg.c3
  %.262 = xor i64 %1, %arg.k1
  %const_mat2 = add i64 %const, -795248199
  %.280 = add nsw i64 %arg.k0, %const_mat2
  %const_mat5 = add i64 %const, -305549691
  %.283 = add nsw i64 %arg.k1, %const_mat5
  %.7.i.1 = mul nsw i64 %.258, 53841
  %.8.i.1 = ashr i64 %.7.i.1, 16
  %.10.i.1 = mul nsw i64 %.258, 8019
  %const_mat17 = add i64 %const, 78839808
  %.11.i.1 = mul i64 %.258, %const_mat17
  %.12.i.1 = and i64 %.11.i.1, 4294901760
  %.13.i.1 = add nsw i64 %.12.i.1, %.10.i.1
  %.14.i.1 = ashr i64 %.13.i.1, 32
  %.15.i.1 = add nsw i64 %.14.i.1, %.8.i.1
  %const_mat27 = add i64 %const, 78847827
  %reass.mul.i.1 = mul i64 %.258, %const_mat27
  %.7.i15.1 = mul nsw i64 %.262, 52638
  %.8.i16.1 = ashr i64 %.7.i15.1, 16
  %.10.i17.1 = mul nsw i64 %.262, 36183
  %.11.i18.1 = mul i64 %.262, %const
  %.12.i19.1 = and i64 %.11.i18.1, 4294836224
  %.13.i20.1 = add nsw i64 %.12.i19.1, %.10.i17.1
  %.14.i21.1 = ashr i64 %.13.i20.1, 32
  %.15.i22.1 = add nsw i64 %.14.i21.1, %.8.i16.1
  %const_mat7 = add i64 %const, 36183
  %reass.mul.i23.1 = mul i64 %.262, %const_mat7
  %.2811 = xor i64 %.280, %reass.mul.i23
  %2 = and i64 %.2811, 4294967295
  %.258.1 = xor i64 %.15.i22.1, %2
  %.2842 = xor i64 %.283, %reass.mul.i
  %3 = and i64 %.2842, 4294967295
  %.262.1 = xor i64 %.15.i.1, %3
  %.280.1 = add i64 %arg.k0, 1013904242
  %.283.1 = add i64 %arg.k1, 1993301258
  %.7.i.2 = mul nsw i64 %.258.1, 53841
  %.8.i.2 = ashr i64 %.7.i.2, 16
  %.10.i.2 = mul nsw i64 %.258.1, 8019
  %const_mat18 = add i64 %const, 78839808
  %.11.i.2 = mul i64 %.258.1, %const_mat18
  %.12.i.2 = and i64 %.11.i.2, 4294901760
  %.13.i.2 = add nsw i64 %.12.i.2, %.10.i.2
  %.14.i.2 = ashr i64 %.13.i.2, 32
  %.15.i.2 = add nsw i64 %.14.i.2, %.8.i.2
  %const_mat28 = add i64 %const, 78847827
  %reass.mul.i.2 = mul i64 %.258.1, %const_mat28
  %.7.i15.2 = mul nsw i64 %.262.1, 52638
  %.8.i16.2 = ashr i64 %.7.i15.2, 16
  %.10.i17.2 = mul nsw i64 %.262.1, 36183
  %.11.i18.2 = mul i64 %.262.1, %const
  %.12.i19.2 = and i64 %.11.i18.2, 4294836224
  %.13.i20.2 = add nsw i64 %.12.i19.2, %.10.i17.2
  %.14.i21.2 = ashr i64 %.13.i20.2, 32
  %.15.i22.2 = add nsw i64 %.14.i21.2, %.8.i16.2
  %const_mat8 = add i64 %const, 36183
  %reass.mul.i23.2 = mul i64 %.262.1, %const_mat8
  %.13.i24.13 = xor i64 %reass.mul.i23.1, %.280.1
  %4 = and i64 %.13.i24.13, 4294967295
  %.258.2 = xor i64 %.15.i22.2, %4
  %.13.i14.14 = xor i64 %reass.mul.i.1, %.283.1
  %5 = and i64 %.13.i14.14, 4294967295
  %.262.2 = xor i64 %.15.i.2, %5
  %const_mat36 = add i64 %const, 218656043
  %.280.2 = add i64 %arg.k0, %const_mat36
  %.283.2 = add i64 %arg.k1, 842468239
  %.7.i.3 = mul nsw i64 %.258.2, 53841
  %.8.i.3 = ashr i64 %.7.i.3, 16
  %.10.i.3 = mul nsw i64 %.258.2, 8019
  %const_mat19 = add i64 %const, 78839808
  %.11.i.3 = mul i64 %.258.2, %const_mat19
  %.12.i.3 = and i64 %.11.i.3, 4294901760
  %.13.i.3 = add nsw i64 %.12.i.3, %.10.i.3
  %.14.i.3 = ashr i64 %.13.i.3, 32
  %.15.i.3 = add nsw i64 %.14.i.3, %.8.i.3
  %const_mat29 = add i64 %const, 78847827
  %reass.mul.i.3 = mul i64 %.258.2, %const_mat29
  %.7.i15.3 = mul nsw i64 %.262.2, 52638
  %.8.i16.3 = ashr i64 %.7.i15.3, 16
  %.10.i17.3 = mul nsw i64 %.262.2, 36183
  %.11.i18.3 = mul i64 %.262.2, %const
  %.12.i19.3 = and i64 %.11.i18.3, 4294836224
  %.13.i20.3 = add nsw i64 %.12.i19.3, %.10.i17.3
  %.14.i21.3 = ashr i64 %.13.i20.3, 32
  %.15.i22.3 = add nsw i64 %.14.i21.3, %.8.i16.3
  %const_mat9 = add i64 %const, 36183
  %reass.mul.i23.3 = mul i64 %.262.2, %const_mat9
  %.13.i24.25 = xor i64 %reass.mul.i23.2, %.280.2
  %6 = and i64 %.13.i24.25, 4294967295
  %.258.3 = xor i64 %.15.i22.3, %6
  %.13.i14.26 = xor i64 %reass.mul.i.2, %.283.2
  %7 = and i64 %.13.i14.26, 4294967295
  %.262.3 = xor i64 %.15.i.3, %7
  %.280.3 = add i64 %arg.k0, 2027808484
  %const_mat38 = add i64 %const, 536918548
  %.283.3 = add i64 %arg.k1, %const_mat38
  %.7.i.4 = mul nsw i64 %.258.3, 53841
  %.8.i.4 = ashr i64 %.7.i.4, 16
  %.10.i.4 = mul nsw i64 %.258.3, 8019
  %const_mat20 = add i64 %const, 78839808
  %.11.i.4 = mul i64 %.258.3, %const_mat20
  %.12.i.4 = and i64 %.11.i.4, 4294901760
  %.13.i.4 = add nsw i64 %.12.i.4, %.10.i.4
  %.14.i.4 = ashr i64 %.13.i.4, 32
  %.15.i.4 = add nsw i64 %.14.i.4, %.8.i.4
  %const_mat30 = add i64 %const, 78847827
  %reass.mul.i.4 = mul i64 %.258.3, %const_mat30
  %.7.i15.4 = mul nsw i64 %.262.3, 52638
  %.8.i16.4 = ashr i64 %.7.i15.4, 16
  %.10.i17.4 = mul nsw i64 %.262.3, 36183
  %.11.i18.4 = mul i64 %.262.3, %const
  %.12.i19.4 = and i64 %.11.i18.4, 4294836224
  %.13.i20.4 = add nsw i64 %.12.i19.4, %.10.i17.4
  %.14.i21.4 = ashr i64 %.13.i20.4, 32
  %.15.i22.4 = add nsw i64 %.14.i21.4, %.8.i16.4
  %const_mat10 = add i64 %const, 36183
  %reass.mul.i23.4 = mul i64 %.262.3, %const_mat10
  %.13.i24.37 = xor i64 %reass.mul.i23.3, %.280.3
  %8 = and i64 %.13.i24.37, 4294967295
  %.258.4 = xor i64 %.15.i22.4, %8
  %.13.i14.38 = xor i64 %reass.mul.i.3, %.283.3
  %9 = and i64 %.13.i14.38, 4294967295
  %.262.4 = xor i64 %.15.i.4, %9
  %.280.4 = add i64 %arg.k0, 387276957
  %const_mat3 = add i64 %const, -613914471
  %.283.4 = add i64 %arg.k1, %const_mat3
  %.7.i.5 = mul nsw i64 %.258.4, 53841
  %.8.i.5 = ashr i64 %.7.i.5, 16
  %.10.i.5 = mul nsw i64 %.258.4, 8019
  %const_mat21 = add i64 %const, 78839808
  %.11.i.5 = mul i64 %.258.4, %const_mat21
  %.12.i.5 = and i64 %.11.i.5, 4294901760
  %.13.i.5 = add nsw i64 %.12.i.5, %.10.i.5
  %.14.i.5 = ashr i64 %.13.i.5, 32
  %.15.i.5 = add nsw i64 %.14.i.5, %.8.i.5
  %const_mat31 = add i64 %const, 78847827
  %reass.mul.i.5 = mul i64 %.258.4, %const_mat31
  %.7.i15.5 = mul nsw i64 %.262.4, 52638
  %.8.i16.5 = ashr i64 %.7.i15.5, 16
  %.10.i17.5 = mul nsw i64 %.262.4, 36183
  %.11.i18.5 = mul i64 %.262.4, %const
  %.12.i19.5 = and i64 %.11.i18.5, 4294836224
  %.13.i20.5 = add nsw i64 %.12.i19.5, %.10.i17.5
  %.14.i21.5 = ashr i64 %.13.i20.5, 32
  %.15.i22.5 = add nsw i64 %.14.i21.5, %.8.i16.5
  %const_mat11 = add i64 %const, 36183
  %reass.mul.i23.5 = mul i64 %.262.4, %const_mat11
  %.13.i24.49 = xor i64 %reass.mul.i23.4, %.280.4
  %10 = and i64 %.13.i24.49, 4294967295
  %.258.5 = xor i64 %.15.i22.5, %10
  %.13.i14.410 = xor i64 %reass.mul.i.4, %.283.4
  %11 = and i64 %.13.i14.410, 4294967295
  %.262.5 = xor i64 %.15.i.5, %11
  %const_mat4 = add i64 %const, -407971242
  %.280.5 = add i64 %arg.k0, %const_mat4
  %.283.5 = add i64 %arg.k1, 1684936478
  %.7.i.6 = mul nsw i64 %.258.5, 53841
  %.8.i.6 = ashr i64 %.7.i.6, 16
  %.10.i.6 = mul nsw i64 %.258.5, 8019
  %const_mat22 = add i64 %const, 78839808
  %.11.i.6 = mul i64 %.258.5, %const_mat22
  %.12.i.6 = and i64 %.11.i.6, 4294901760
  %.13.i.6 = add nsw i64 %.12.i.6, %.10.i.6
  %.14.i.6 = ashr i64 %.13.i.6, 32
  %.15.i.6 = add nsw i64 %.14.i.6, %.8.i.6
  %const_mat32 = add i64 %const, 78847827
  %reass.mul.i.6 = mul i64 %.258.5, %const_mat32
  %.7.i15.6 = mul nsw i64 %.262.5, 52638
  %.8.i16.6 = ashr i64 %.7.i15.6, 16
  %.10.i17.6 = mul nsw i64 %.262.5, 36183
  %.11.i18.6 = mul i64 %.262.5, %const
  %.12.i19.6 = and i64 %.11.i18.6, 4294836224
  %.13.i20.6 = add nsw i64 %.12.i19.6, %.10.i17.6
  %.14.i21.6 = ashr i64 %.13.i20.6, 32
  %.15.i22.6 = add nsw i64 %.14.i21.6, %.8.i16.6
  %const_mat12 = add i64 %const, 36183
  %reass.mul.i23.6 = mul i64 %.262.5, %const_mat12
  %.13.i24.511 = xor i64 %reass.mul.i23.5, %.280.5
  %12 = and i64 %.13.i24.511, 4294967295
  %.258.6 = xor i64 %.15.i22.6, %12
  %.13.i14.512 = xor i64 %reass.mul.i.5, %.283.5
  %13 = and i64 %.13.i14.512, 4294967295
  %.262.6 = xor i64 %.15.i.6, %13
  %.280.6 = add i64 %arg.k0, 1401181199
  %.283.6 = add i64 %arg.k1, 534103459
  %.7.i.7 = mul nsw i64 %.258.6, 53841
  %.8.i.7 = ashr i64 %.7.i.7, 16
  %.10.i.7 = mul nsw i64 %.258.6, 8019
  %const_mat23 = add i64 %const, 78839808
  %.11.i.7 = mul i64 %.258.6, %const_mat23
  %.12.i.7 = and i64 %.11.i.7, 4294901760
  %.13.i.7 = add nsw i64 %.12.i.7, %.10.i.7
  %.14.i.7 = ashr i64 %.13.i.7, 32
  %.15.i.7 = add nsw i64 %.14.i.7, %.8.i.7
  %const_mat33 = add i64 %const, 78847827
  %reass.mul.i.7 = mul i64 %.258.6, %const_mat33
  %.7.i15.7 = mul nsw i64 %.262.6, 52638
  %.8.i16.7 = ashr i64 %.7.i15.7, 16
  %.10.i17.7 = mul nsw i64 %.262.6, 36183
  %.11.i18.7 = mul i64 %.262.6, %const
  %.12.i19.7 = and i64 %.11.i18.7, 4294836224
  %.13.i20.7 = add nsw i64 %.12.i19.7, %.10.i17.7
  %.14.i21.7 = ashr i64 %.13.i20.7, 32
  %.15.i22.7 = add nsw i64 %.14.i21.7, %.8.i16.7
  %const_mat13 = add i64 %const, 36183
  %reass.mul.i23.7 = mul i64 %.262.6, %const_mat13
  %.13.i24.613 = xor i64 %reass.mul.i23.6, %.280.6
  %14 = and i64 %.13.i24.613, 4294967295
  %.258.7 = xor i64 %.15.i22.7, %14
  %.13.i14.614 = xor i64 %reass.mul.i.6, %.283.6
  %15 = and i64 %.13.i14.614, 4294967295
  %.262.7 = xor i64 %.15.i.7, %15
  %const_mat39 = add i64 %const, 605933000
  %.280.7 = add i64 %arg.k0, %const_mat39
  %const_mat37 = add i64 %const, 228553768
  %.283.7 = add i64 %arg.k1, %const_mat37
  %.7.i.8 = mul nsw i64 %.258.7, 53841
  %.8.i.8 = ashr i64 %.7.i.8, 16
  %.10.i.8 = mul nsw i64 %.258.7, 8019
  %const_mat24 = add i64 %const, 78839808
  %.11.i.8 = mul i64 %.258.7, %const_mat24
  %.12.i.8 = and i64 %.11.i.8, 4294901760
  %.13.i.8 = add nsw i64 %.12.i.8, %.10.i.8
  %.14.i.8 = ashr i64 %.13.i.8, 32
  %.15.i.8 = add nsw i64 %.14.i.8, %.8.i.8
  %const_mat34 = add i64 %const, 78847827
  %reass.mul.i.8 = mul i64 %.258.7, %const_mat34
  %.7.i15.8 = mul nsw i64 %.262.7, 52638
  %.8.i16.8 = ashr i64 %.7.i15.8, 16
  %.10.i17.8 = mul nsw i64 %.262.7, 36183
  %.11.i18.8 = mul i64 %.262.7, %const
  %.12.i19.8 = and i64 %.11.i18.8, 4294836224
  %.13.i20.8 = add nsw i64 %.12.i19.8, %.10.i17.8
  %.14.i21.8 = ashr i64 %.13.i20.8, 32
  %.15.i22.8 = add nsw i64 %.14.i21.8, %.8.i16.8
  %const_mat14 = add i64 %const, 36183
  %reass.mul.i23.8 = mul i64 %.262.7, %const_mat14
  %.13.i24.715 = xor i64 %reass.mul.i23.7, %.280.7
  %16 = and i64 %.13.i24.715, 4294967295
  %.258.8 = xor i64 %.15.i22.8, %16
  %.13.i14.716 = xor i64 %reass.mul.i.7, %.283.7
  %17 = and i64 %.13.i14.716, 4294967295
  %.262.8 = xor i64 %.15.i.8, %17
  %const_mat = add i64 %const, -1034598527
  %.280.8 = add i64 %arg.k0, %const_mat
  %const_mat1 = add i64 %const, -922279251
  %.283.8 = add i64 %arg.k1, %const_mat1
  %.7.i.9 = mul nsw i64 %.258.8, 53841
  %.8.i.9 = ashr i64 %.7.i.9, 16
  %.10.i.9 = mul nsw i64 %.258.8, 8019
  %const_mat25 = add i64 %const, 78839808
  %.11.i.9 = mul i64 %.258.8, %const_mat25
  %.12.i.9 = and i64 %.11.i.9, 4294901760
  %.13.i.9 = add nsw i64 %.12.i.9, %.10.i.9
  %.14.i.9 = ashr i64 %.13.i.9, 32
  %.15.i.9 = add nsw i64 %.14.i.9, %.8.i.9
  %const_mat35 = add i64 %const, 78847827
  %reass.mul.i.9 = mul i64 %.258.8, %const_mat35
  %.13.i14.9 = and i64 %reass.mul.i.9, 4294967295
  %.7.i15.9 = mul nsw i64 %.262.8, 52638
  %.8.i16.9 = ashr i64 %.7.i15.9, 16
  %.10.i17.9 = mul nsw i64 %.262.8, 36183
  %.11.i18.9 = mul i64 %.262.8, %const
  %.12.i19.9 = and i64 %.11.i18.9, 4294836224
  %.13.i20.9 = add nsw i64 %.12.i19.9, %.10.i17.9
  %.14.i21.9 = ashr i64 %.13.i20.9, 32
  %.15.i22.9 = add nsw i64 %.14.i21.9, %.8.i16.9
  %const_mat15 = add i64 %const, 36183
  %reass.mul.i23.9 = mul i64 %.262.8, %const_mat15
  %.13.i24.9 = and i64 %reass.mul.i23.9, 4294967295
  %.13.i24.817 = xor i64 %reass.mul.i23.8, %.280.8
  %18 = and i64 %.13.i24.817, 4294967295
  %.258.9 = xor i64 %.15.i22.9, %18
  %.13.i14.818 = xor i64 %reass.mul.i.8, %.283.8
  %19 = and i64 %.13.i14.818, 4294967295
  %.262.9 = xor i64 %.15.i.9, %19
  store i64 %.258.9, ptr %retptr, align 8
  %retptr.repack67 = getelementptr inbounds i8, ptr %retptr, i64 8
  store i64 %.13.i24.9, ptr %retptr.repack67, align 8
  %retptr.repack69 = getelementptr inbounds i8, ptr %retptr, i64 16
  store i64 %.262.9, ptr %retptr.repack69, align 8
  %retptr.repack71 = getelementptr inbounds i8, ptr %retptr, i64 24
  store i64 %.13.i14.9, ptr %retptr.repack71, align 8
  ret i32 0
}
declare double @llvm.log.f64(double)
declare double @sqrt(double)
declare double @llvm.cos.f64(double)
declare double @llvm.pow.f64(double, double)
define linkonce_odr i32 @f81(ptr noalias writeonly %retptr, ptr noalias writeonly %excinfo, ptr readnone %arg.z.0, ptr readnone %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %arg.u, i64 %arg.g, i64 %arg.n, ptr readnone %arg.settings.0, ptr readnone %arg.settings.1, i64 %arg.settings.2, i64 %arg.settings.3, ptr readonly %arg.settings.4, i64 %arg.settings.5.0, i64 %arg.settings.6.0, i64 %arg.k, ptr readnone %arg.work.0, ptr readnone %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0) {
B0.endif.endif:
  %.585 = alloca i64, align 8
  %excinfo.3 = alloca ptr, align 8
  %.91 = getelementptr i8, ptr %arg.work.4, i64 8
  %.92 = load double, ptr %.91, align 8
  %.5.i = fptosi double %.92 to i64
  %.202262.not = icmp slt i64 %arg.n, 1
  br i1 %.202262.not, label %B278, label %B148.lr.ph
B148:                                             ; preds = %B148.lr.ph, %B148
  %lsr.iv = phi i64 [ %12, %B148.lr.ph ], [ %lsr.iv.next, %B148 ]
  %.208261263 = phi i64 [ 0, %B148.lr.ph ], [ %.215, %B148 ]
  %.215 = add nuw nsw i64 %.208261263, 1
  %0 = add i64 %arg.g, %.208261263
  %.255 = icmp slt i64 %0, 0
  %1 = select i1 %.255, i64 %15, i64 0
  %scevgep8 = getelementptr i8, ptr %scevgep7, i64 %1
  %2 = shl i64 %.208261263, 3
  %scevgep9 = getelementptr i8, ptr %scevgep8, i64 %2
  %.271 = load double, ptr %scevgep9, align 8
  %3 = add i64 %arg.u, %.208261263
  %.287 = icmp slt i64 %3, 0
  %4 = select i1 %.287, i64 %15, i64 0
  %scevgep5 = getelementptr i8, ptr %scevgep4, i64 %4
  %5 = shl i64 %.208261263, 3
  %scevgep10 = getelementptr i8, ptr %scevgep5, i64 %5
  %.303 = load double, ptr %scevgep10, align 8
  %.304 = fsub double %.271, %.303
  %sunkaddr = mul i64 %.208261263, 8
  %sunkaddr11 = getelementptr i8, ptr %arg.work.4, i64 %sunkaddr
  %sunkaddr12 = getelementptr i8, ptr %sunkaddr11, i64 48
  %.336 = load double, ptr %sunkaddr12, align 8
  %.337 = fsub double %.304, %.336
  %sunkaddr13 = getelementptr i8, ptr %arg.work.4, i64 40
  %.367 = load double, ptr %sunkaddr13, align 8
  %.371 = fdiv double %.337, %.367
  %.391 = icmp slt i64 %lsr.iv, 0
  %6 = select i1 %.391, i64 %16, i64 0
  %scevgep = getelementptr i8, ptr %arg.work.4, i64 %6
  %7 = shl i64 %lsr.iv, 3
  %scevgep1 = getelementptr i8, ptr %scevgep, i64 %7
  store double %.371, ptr %scevgep1, align 8
  %lsr.iv.next = add i64 %lsr.iv, %arg.n
  %exitcond.not = icmp eq i64 %arg.n, %.215
  br i1 %exitcond.not, label %B278, label %B148
B278:                                             ; preds = %B148, %B0.endif.endif
  %.50.pre-phi = add i64 %.5.i, 6
  %.421 = add i64 %.50.pre-phi, %arg.n
  %.437 = icmp slt i64 %.421, 0
  %.438 = select i1 %.437, i64 %arg.work.5.0, i64 0
  %8 = getelementptr double, ptr %arg.work.4, i64 %.421
  %.452 = getelementptr double, ptr %8, i64 %.438
  %.453 = load double, ptr %.452, align 8
  %.456 = add nsw i64 %arg.u, %.5.i
  %.470 = icmp slt i64 %.456, 0
  %.471 = select i1 %.470, i64 %arg.z.5.0, i64 0
  %9 = getelementptr double, ptr %arg.z.4, i64 %.456
  %.485 = getelementptr double, ptr %9, i64 %.471
  store double %.453, ptr %.485, align 8
  %.488 = add nsw i64 %.5.i, 1
  %.490 = icmp slt i64 %.488, %arg.n
  br i1 %.490, label %B330.endif, label %B390
B390:                                             ; preds = %B278
  %sunkaddr14 = getelementptr i8, ptr %arg.work.4, i64 8
  store double -1.000000e+00, ptr %sunkaddr14, align 8
  store i64 0, ptr %.585, align 8
  %.593 = call i32 @f82(ptr nonnull %.585, ptr nonnull %excinfo.3, ptr %arg.z.0, ptr %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr nonnull %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %arg.u, i64 %arg.n, ptr %arg.work.0, ptr %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr nonnull %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0)
  switch i32 %.593, label %B390.if.if [
    i32 -2, label %B390.endif
    i32 0, label %B390.endif
  ]
common.ret:                                       ; preds = %B390.if.if, %B390.endif, %B330.endif
  %common.ret.op = phi i32 [ %.593, %B390.if.if ], [ 0, %B330.endif ], [ 0, %B390.endif ]
  ret i32 %common.ret.op
B148.lr.ph:                                       ; preds = %B0.endif.endif
  %10 = shl nuw i64 %arg.n, 1
  %11 = add i64 %10, 6
  %12 = add i64 %11, %.5.i
  %13 = shl i64 %arg.u, 3
  %scevgep4 = getelementptr i8, ptr %arg.z.4, i64 %13
  %14 = shl i64 %arg.g, 3
  %scevgep7 = getelementptr i8, ptr %arg.z.4, i64 %14
  %15 = shl i64 %arg.z.5.0, 3
  %16 = shl i64 %arg.work.5.0, 3
  br label %B148
B330.endif:                                       ; preds = %B278
  %.62.i = sitofp i64 %.488 to double
  %sunkaddr15 = getelementptr i8, ptr %arg.work.4, i64 8
  store double %.62.i, ptr %sunkaddr15, align 8
  %.64.i = add i64 %arg.k, 4
  %.65.i = add i64 %.64.i, %.5.i
  %.78.i = icmp slt i64 %.65.i, 0
  %.79.i = select i1 %.78.i, i64 %arg.settings.5.0, i64 0
  %17 = getelementptr double, ptr %arg.settings.4, i64 %.65.i
  %.93.i = getelementptr double, ptr %17, i64 %.79.i
  %.94.i = load double, ptr %.93.i, align 8
  %.95.i = add nsw i64 %.488, %arg.u
  %.108.i = icmp slt i64 %.95.i, 0
  %.109.i = select i1 %.108.i, i64 %arg.z.5.0, i64 0
  %18 = getelementptr double, ptr %arg.z.4, i64 %.95.i
  %.123.i = getelementptr double, ptr %18, i64 %.109.i
  %.124.i = load double, ptr %.123.i, align 8
  %.125.i = tail call double @llvm.fabs.f64(double %.124.i)
  %.10.i.i = fcmp ogt double %.125.i, %.94.i
  %.11.i.i = select i1 %.10.i.i, double %.125.i, double %.94.i
  %.156.i = fmul double %.11.i.i, 0x3E50000000000000
  %.184.i = getelementptr i8, ptr %arg.work.4, i64 40
  store double %.156.i, ptr %.184.i, align 8
  %.215.i = load double, ptr %.123.i, align 8
  %.245.i = fadd double %.215.i, %.156.i
  store double %.245.i, ptr %.123.i, align 8
  store i64 1, ptr %retptr, align 8
  br label %common.ret
B390.endif:                                       ; preds = %B390, %B390
  %.603 = load i64, ptr %.585, align 8
  store i64 %.603, ptr %retptr, align 8
  br label %common.ret
B390.if.if:                                       ; preds = %B390
  store ptr null, ptr %excinfo, align 8
  br label %common.ret
}
define linkonce_odr noundef i32 @f82(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.z.0, ptr readnone %arg.z.1, i64 %arg.z.2, i64 %arg.z.3, ptr %arg.z.4, i64 %arg.z.5.0, i64 %arg.z.6.0, i64 %arg.u, i64 %arg.n, ptr readnone %arg.work.0, ptr readnone %arg.work.1, i64 %arg.work.2, i64 %arg.work.3, ptr %arg.work.4, i64 %arg.work.5.0, i64 %arg.work.6.0) {
B0.endif:
  %.35 = shl i64 %arg.n, 1
  %.36 = add nsw i64 %.35, 6
  %.48 = mul i64 %arg.n, %arg.n
  %.50 = add nsw i64 %.36, %.48
  %.138985 = icmp sgt i64 %.48, 0
  br i1 %.138985, label %B118.preheader, label %B156.endif
B118.preheader:                                   ; preds = %B0.endif
  %0 = icmp eq i64 %.48, 1
  br i1 %0, label %B118.epil.preheader, label %B118.preheader.new
B118.preheader.new:                               ; preds = %B118.preheader
  %const37 = bitcast i64 9223372036854775806 to i64
  %unroll_iter = and i64 %.48, %const37
  %1 = shl i64 %arg.n, 4
  %scevgep111 = getelementptr i8, ptr %arg.work.4, i64 %1
  %2 = add i64 %arg.n, 2
  %3 = mul i64 %2, %arg.n
  %4 = shl i64 %3, 3
  %scevgep115 = getelementptr i8, ptr %arg.work.4, i64 %4
  %5 = shl i64 %arg.work.5.0, 3
  %6 = add i64 %5, 48
  %7 = add i64 %5, 56
  br label %B118
B118:                                             ; preds = %B118, %B118.preheader.new
  %.144984986 = phi i64 [ 0, %B118.preheader.new ], [ %.151.1, %B118 ]
  %8 = add i64 %.35, %.144984986
  %9 = add i64 %8, 6
  %.191 = icmp slt i64 %9, 0
  %10 = shl i64 %.144984986, 3
  %11 = select i1 %.191, i64 %6, i64 48
  %scevgep56 = getelementptr i8, ptr %scevgep111, i64 %11
  %scevgep57 = getelementptr i8, ptr %scevgep56, i64 %10
  %.207 = load double, ptr %scevgep57, align 8
  %12 = add i64 %3, %.144984986
  %13 = add i64 %12, 6
  %.223 = icmp slt i64 %13, 0
  %14 = select i1 %.223, i64 %6, i64 48
  %scevgep53 = getelementptr i8, ptr %scevgep115, i64 %14
  %15 = shl i64 %.144984986, 3
  %scevgep36 = getelementptr i8, ptr %scevgep53, i64 %15
  store double %.207, ptr %scevgep36, align 8
  %.151.1 = add nuw i64 %.144984986, 2
  %16 = add i64 %.35, %.144984986
  %17 = add i64 %16, 7
  %.191.1 = icmp slt i64 %17, 0
  %18 = select i1 %.191.1, i64 %7, i64 56
  %scevgep51 = getelementptr i8, ptr %scevgep111, i64 %18
  %19 = shl i64 %.144984986, 3
  %scevgep31 = getelementptr i8, ptr %scevgep51, i64 %19
  %.207.1 = load double, ptr %scevgep31, align 8
  %20 = add i64 %3, %.144984986
  %21 = add i64 %20, 7
  %.223.1 = icmp slt i64 %21, 0
  %22 = select i1 %.223.1, i64 %7, i64 56
  %scevgep48 = getelementptr i8, ptr %scevgep115, i64 %22
  %23 = shl i64 %.144984986, 3
  %scevgep29 = getelementptr i8, ptr %scevgep48, i64 %23
  store double %.207.1, ptr %scevgep29, align 8
  %niter.ncmp.1 = icmp eq i64 %unroll_iter, %.151.1
  br i1 %niter.ncmp.1, label %B156.endif.loopexit.unr-lcssa, label %B118
B188:                                             ; preds = %B188.preheader.new, %B188
  %.333990992 = phi i64 [ 0, %B188.preheader.new ], [ %.340.1, %B188 ]
  %sunkaddr = mul i64 %.333990992, 8
  %sunkaddr38 = getelementptr i8, ptr %arg.work.4, i64 %sunkaddr
  %sunkaddr39 = getelementptr i8, ptr %sunkaddr38, i64 48
  %.396 = load double, ptr %sunkaddr39, align 8
  %.397 = fneg double %.396
  %24 = add i64 %arg.u, %.333990992
  %.413 = icmp slt i64 %24, 0
  %25 = select i1 %.413, i64 %115, i64 0
  %scevgep109 = getelementptr i8, ptr %scevgep105, i64 %25
  %26 = shl i64 %.333990992, 3
  %scevgep21 = getelementptr i8, ptr %scevgep109, i64 %26
  store double %.397, ptr %scevgep21, align 8
  %.340.1 = add nuw i64 %.333990992, 2
  %sunkaddr40 = mul i64 %.333990992, 8
  %sunkaddr41 = getelementptr i8, ptr %arg.work.4, i64 %sunkaddr40
  %sunkaddr42 = getelementptr i8, ptr %sunkaddr41, i64 56
  %.396.1 = load double, ptr %sunkaddr42, align 8
  %.397.1 = fneg double %.396.1
  %27 = add i64 %arg.u, %.333990992
  %28 = add i64 %27, 1
  %.413.1 = icmp slt i64 %28, 0
  %29 = select i1 %.413.1, i64 %116, i64 8
  %scevgep39 = getelementptr i8, ptr %scevgep105, i64 %29
  %30 = shl i64 %.333990992, 3
  %scevgep19 = getelementptr i8, ptr %scevgep39, i64 %30
  store double %.397.1, ptr %scevgep19, align 8
  %niter12.ncmp.1 = icmp eq i64 %unroll_iter11, %.340.1
  br i1 %niter12.ncmp.1, label %B262.endif.preheader.unr-lcssa, label %B188
B262.endif.preheader.unr-lcssa:                   ; preds = %B188
  %31 = and i64 %arg.n, 1
  %lcmp.mod9.not = icmp eq i64 %31, 0
  br i1 %lcmp.mod9.not, label %B262.endif.preheader, label %B188.epil.preheader
B188.epil.preheader:                              ; preds = %B188.preheader, %B262.endif.preheader.unr-lcssa
  %.pre5.pre-phi = phi i64 [ %unroll_iter11, %B262.endif.preheader.unr-lcssa ], [ 0, %B188.preheader ]
  %32 = getelementptr double, ptr %arg.work.4, i64 %.pre5.pre-phi
  %33 = getelementptr i8, ptr %32, i64 48
  %.396.epil = load double, ptr %33, align 8
  %.397.epil = fneg double %.396.epil
  %.399.epil = add nsw i64 %.pre5.pre-phi, %arg.u
  %.413.epil = icmp slt i64 %.399.epil, 0
  %.414.epil = select i1 %.413.epil, i64 %arg.z.5.0, i64 0
  %34 = getelementptr double, ptr %arg.z.4, i64 %.399.epil
  %.428.epil = getelementptr double, ptr %34, i64 %.414.epil
  store double %.397.epil, ptr %.428.epil, align 8
  br label %B262.endif.preheader
B262.endif.preheader:                             ; preds = %B188.epil.preheader, %B262.endif.preheader.unr-lcssa
  %.pre-phi = phi i1 [ false, %B188.epil.preheader ], [ true, %B262.endif.preheader.unr-lcssa ]
  %unroll_iter16.pre-phi = phi i64 [ %.pre5.pre-phi, %B188.epil.preheader ], [ %unroll_iter11, %B262.endif.preheader.unr-lcssa ]
  %35 = add nuw i64 %arg.n, 3
  %36 = mul i64 %35, %arg.n
  %37 = add i64 %36, 6
  %38 = add nuw i64 %arg.n, 1
  %39 = shl i64 %arg.n, 3
  %40 = add nuw i64 %arg.n, 2
  %41 = mul i64 %40, %arg.n
  %42 = shl i64 %41, 3
  %scevgep65 = getelementptr i8, ptr %arg.work.4, i64 %42
  %43 = shl i64 %36, 3
  %scevgep83 = getelementptr i8, ptr %arg.work.4, i64 %43
  %44 = shl i64 %arg.work.5.0, 3
  %45 = add i64 %44, 48
  %46 = add i64 %44, 56
  br label %B262.endif
B260.loopexit:                                    ; preds = %B960, %B654.endif
  %lsr.iv.next51 = add i64 %lsr.iv50, -1
  %lsr.iv.next57 = add i64 %38, %lsr.iv56
  %scevgep67 = getelementptr i8, ptr %lsr.iv66, i64 %39
  %lsr.iv.next72 = add i64 %lsr.iv71, %arg.n
  %scevgep85 = getelementptr i8, ptr %lsr.iv84, i64 %39
  %lsr.iv.next92 = add i64 %lsr.iv91, %arg.n
  %indvars.iv.next = add nuw i64 %indvars.iv, 1
  %exitcond1112.not = icmp eq i64 %arg.n, %.531
  br i1 %exitcond1112.not, label %B1070.endif.preheader, label %B262.endif
B1070.endif.preheader:                            ; preds = %B260.loopexit
  %47 = add i64 %arg.n, %arg.u
  %48 = add i64 %.35, 2
  %49 = mul i64 %48, %arg.n
  %50 = add i64 %49, 6
  %51 = xor i64 %arg.n, -1
  %52 = shl i64 %arg.z.5.0, 3
  br label %B1070.endif
B308:                                             ; preds = %B308.lr.ph, %B308
  %lsr.iv7 = phi i64 [ %indvars.iv, %B308.lr.ph ], [ %lsr.iv.next8, %B308 ]
  %lsr.iv58 = phi i64 [ %lsr.iv56, %B308.lr.ph ], [ %lsr.iv.next59, %B308 ]
  %pivot.2.11001 = phi i64 [ %.52410331061, %B308.lr.ph ], [ %pivot.3.2, %B308 ]
  %.710 = icmp slt i64 %lsr.iv58, 0
  %53 = select i1 %.710, i64 %44, i64 0
  %scevgep55 = getelementptr i8, ptr %arg.work.4, i64 %53
  %54 = shl i64 %lsr.iv58, 3
  %scevgep60 = getelementptr i8, ptr %scevgep55, i64 %54
  %.726 = load double, ptr %scevgep60, align 8
  %.727 = tail call double @llvm.fabs.f64(double %.726)
  %.730 = mul nsw i64 %pivot.2.11001, %arg.n
  %.736 = add i64 %.694, %.730
  %.750 = icmp slt i64 %.736, 0
  %.751 = select i1 %.750, i64 %arg.work.5.0, i64 0
  %55 = getelementptr double, ptr %arg.work.4, i64 %.736
  %.765 = getelementptr double, ptr %55, i64 %.751
  %.766 = load double, ptr %.765, align 8
  %.767 = tail call double @llvm.fabs.f64(double %.766)
  %.768 = fcmp ogt double %.727, %.767
  %pivot.3.2 = select i1 %.768, i64 %lsr.iv7, i64 %pivot.2.11001
  %lsr.iv.next59 = add i64 %lsr.iv58, %arg.n
  %lsr.iv.next8 = add i64 %lsr.iv7, 1
  %exitcond.not = icmp eq i64 %arg.n, %lsr.iv.next8
  br i1 %exitcond.not, label %B440, label %B308
B440:                                             ; preds = %B308, %B262.endif
  %pivot.2.1.lcssa = phi i64 [ %.52410331061, %B262.endif ], [ %pivot.3.2, %B308 ]
  %.790 = mul nsw i64 %pivot.2.1.lcssa, %arg.n
  %.792 = add nsw i64 %.790, %.50
  %.794 = add nsw i64 %.792, %.52410331061
  %.808 = icmp slt i64 %.794, 0
  %.809 = select i1 %.808, i64 %arg.work.5.0, i64 0
  %56 = getelementptr double, ptr %arg.work.4, i64 %.794
  %.823 = getelementptr double, ptr %56, i64 %.809
  %.824 = load double, ptr %.823, align 8
  %.825 = fcmp oeq double %.824, 0.000000e+00
  br i1 %.825, label %common.ret, label %B532.lr.ph
common.ret.loopexit.unr-lcssa:                    ; preds = %B1310
  br i1 %.pre-phi, label %common.ret, label %B1310.epil.preheader
B1310.epil.preheader:                             ; preds = %common.ret.loopexit.unr-lcssa, %B1310.preheader
  %.237710951097.epil.init = phi i64 [ 0, %B1310.preheader ], [ %unroll_iter16.pre-phi, %common.ret.loopexit.unr-lcssa ]
  %.2410.epil = add nsw i64 %.237710951097.epil.init, %arg.u
  %.2424.epil = icmp slt i64 %.2410.epil, 0
  %.2425.epil = select i1 %.2424.epil, i64 %arg.z.5.0, i64 0
  %57 = getelementptr double, ptr %arg.z.4, i64 %.2410.epil
  %.2439.epil = getelementptr double, ptr %57, i64 %.2425.epil
  %.2440.epil = load double, ptr %.2439.epil, align 8
  %58 = getelementptr double, ptr %131, i64 %.237710951097.epil.init
  %.2472.epil = load double, ptr %58, align 8
  %.2473.epil = fadd double %.2440.epil, %.2472.epil
  store double %.2473.epil, ptr %.2439.epil, align 8
  br label %common.ret
common.ret:                                       ; preds = %B440, %B156.endif, %B1310.epil.preheader, %common.ret.loopexit.unr-lcssa
  %storemerge971 = phi i64 [ 1, %B1310.epil.preheader ], [ 1, %B156.endif ], [ 1, %common.ret.loopexit.unr-lcssa ], [ 2, %B440 ]
  store i64 %storemerge971, ptr %retptr, align 8
  ret i32 0
B532:                                             ; preds = %B532.preheader, %B532
  %.93310061008 = phi i64 [ %.940.1, %B532 ], [ 0, %B532.preheader ]
  %59 = add i64 %122, %.93310061008
  %60 = add i64 %59, 6
  %.984 = icmp slt i64 %60, 0
  %61 = shl i64 %.93310061008, 3
  %62 = select i1 %.984, i64 %45, i64 48
  %scevgep24 = getelementptr i8, ptr %scevgep61, i64 %62
  %scevgep25 = getelementptr i8, ptr %scevgep24, i64 %61
  %.1000 = load double, ptr %scevgep25, align 8
  %63 = add i64 %lsr.iv71, %.93310061008
  %64 = add i64 %63, 6
  %.1020 = icmp slt i64 %64, 0
  %65 = select i1 %.1020, i64 %45, i64 48
  %scevgep22 = getelementptr i8, ptr %lsr.iv66, i64 %65
  %66 = shl i64 %.93310061008, 3
  %scevgep10 = getelementptr i8, ptr %scevgep22, i64 %66
  %.1036 = load double, ptr %scevgep10, align 8
  store double %.1000, ptr %scevgep10, align 8
  store double %.1036, ptr %scevgep25, align 8
  %.940.1 = add nuw i64 %.93310061008, 2
  %67 = add i64 %122, %.93310061008
  %68 = add i64 %67, 7
  %.984.1 = icmp slt i64 %68, 0
  %69 = select i1 %.984.1, i64 %46, i64 56
  %scevgep20 = getelementptr i8, ptr %scevgep61, i64 %69
  %70 = shl i64 %.93310061008, 3
  %scevgep9 = getelementptr i8, ptr %scevgep20, i64 %70
  %.1000.1 = load double, ptr %scevgep9, align 8
  %71 = add i64 %lsr.iv71, %.93310061008
  %72 = add i64 %71, 7
  %.1020.1 = icmp slt i64 %72, 0
  %73 = select i1 %.1020.1, i64 %46, i64 56
  %scevgep18 = getelementptr i8, ptr %lsr.iv66, i64 %73
  %74 = shl i64 %.93310061008, 3
  %scevgep7 = getelementptr i8, ptr %scevgep18, i64 %74
  %.1036.1 = load double, ptr %scevgep7, align 8
  store double %.1000.1, ptr %scevgep7, align 8
  store double %.1036.1, ptr %scevgep9, align 8
  %niter17.ncmp.1 = icmp eq i64 %unroll_iter16.pre-phi, %.940.1
  br i1 %niter17.ncmp.1, label %B654.endif.unr-lcssa, label %B532
B870.preheader:                                   ; preds = %B764.lr.ph, %B960
  %lsr.iv93 = phi i64 [ %lsr.iv.next94, %B960 ], [ %lsr.iv91, %B764.lr.ph ]
  %lsr.iv86 = phi ptr [ %scevgep87, %B960 ], [ %lsr.iv84, %B764.lr.ph ]
  %.133610201026 = phi i64 [ %.1343, %B960 ], [ %.531, %B764.lr.ph ]
  %75 = and i64 %smax28, 1
  %76 = icmp eq i64 %75, 0
  %.1373 = mul nsw i64 %.133610201026, %arg.n
  %.1377 = add i64 %.1375, %.1373
  %.1391 = icmp slt i64 %.1377, 0
  %.1392 = select i1 %.1391, i64 %arg.work.5.0, i64 0
  %77 = getelementptr double, ptr %arg.work.4, i64 %.1377
  %.1406 = getelementptr double, ptr %77, i64 %.1392
  %.1407 = load double, ptr %.1406, align 8
  %sunkaddr43 = getelementptr inbounds i8, ptr %127, i64 %sunkaddr131
  %.1444 = load double, ptr %sunkaddr43, align 8
  %.1448 = fdiv double %.1407, %.1444
  br i1 %76, label %B870.prol.loopexit, label %B870.prol
B870.prol:                                        ; preds = %B870.preheader
  %.1644.prol = fmul double %.1444, %.1448
  %.1645.prol = fsub double %.1407, %.1644.prol
  %sunkaddr65 = shl i64 %.1392, 3
  %sunkaddr66 = getelementptr inbounds i8, ptr %77, i64 %sunkaddr65
  store double %.1645.prol, ptr %sunkaddr66, align 8
  br label %B870.prol.loopexit
B870.prol.loopexit:                               ; preds = %B870.prol, %B870.preheader
  %.153910131015.unr = phi i64 [ %.52410331061, %B870.preheader ], [ %.531, %B870.prol ]
  %78 = icmp eq i64 %.51710321062, 1
  br i1 %78, label %B960, label %B870.preheader5
B870.preheader5:                                  ; preds = %B870.prol.loopexit
  br label %B870
B870:                                             ; preds = %B870.preheader5, %B870
  %.153910131015 = phi i64 [ %.1546.1, %B870 ], [ %.153910131015.unr, %B870.preheader5 ]
  %79 = add i64 %lsr.iv93, %.153910131015
  %80 = add i64 %79, 6
  %.1590 = icmp slt i64 %80, 0
  %81 = select i1 %.1590, i64 %44, i64 0
  %scevgep88 = getelementptr i8, ptr %lsr.iv86, i64 %81
  %82 = shl i64 %.153910131015, 3
  %scevgep89 = getelementptr i8, ptr %scevgep88, i64 %82
  %scevgep90 = getelementptr i8, ptr %scevgep89, i64 48
  %.1606 = load double, ptr %scevgep90, align 8
  %83 = add i64 %lsr.iv71, %.153910131015
  %84 = add i64 %83, 6
  %.1626 = icmp slt i64 %84, 0
  %85 = select i1 %.1626, i64 %44, i64 0
  %scevgep80 = getelementptr i8, ptr %lsr.iv66, i64 %85
  %86 = shl i64 %.153910131015, 3
  %scevgep16 = getelementptr i8, ptr %scevgep80, i64 %86
  %scevgep17 = getelementptr i8, ptr %scevgep16, i64 48
  %.1642 = load double, ptr %scevgep17, align 8
  %.1644 = fmul double %.1448, %.1642
  %.1645 = fsub double %.1606, %.1644
  store double %.1645, ptr %scevgep90, align 8
  %.1546.1 = add nuw i64 %.153910131015, 2
  %87 = add i64 %lsr.iv93, %.153910131015
  %88 = add i64 %87, 7
  %.1590.1 = icmp slt i64 %88, 0
  %89 = select i1 %.1590.1, i64 %44, i64 0
  %scevgep98 = getelementptr i8, ptr %lsr.iv86, i64 %89
  %90 = shl i64 %.153910131015, 3
  %scevgep14 = getelementptr i8, ptr %scevgep98, i64 %90
  %scevgep15 = getelementptr i8, ptr %scevgep14, i64 56
  %.1606.1 = load double, ptr %scevgep15, align 8
  %91 = add i64 %lsr.iv71, %.153910131015
  %92 = add i64 %91, 7
  %.1626.1 = icmp slt i64 %92, 0
  %93 = select i1 %.1626.1, i64 %44, i64 0
  %scevgep95 = getelementptr i8, ptr %lsr.iv66, i64 %93
  %94 = shl i64 %.153910131015, 3
  %scevgep11 = getelementptr i8, ptr %scevgep95, i64 %94
  %scevgep13 = getelementptr i8, ptr %scevgep11, i64 56
  %.1642.1 = load double, ptr %scevgep13, align 8
  %.1644.1 = fmul double %.1448, %.1642.1
  %.1645.1 = fsub double %.1606.1, %.1644.1
  store double %.1645.1, ptr %scevgep15, align 8
  %exitcond1111.not.1 = icmp eq i64 %117, %.1546.1
  br i1 %exitcond1111.not.1, label %B960, label %B870
B960:                                             ; preds = %B870, %B870.prol.loopexit
  %.1343 = add nuw i64 %.133610201026, 1
  %.1683 = add nsw i64 %.133610201026, %arg.u
  %.1699 = icmp slt i64 %.1683, 0
  %.1700 = select i1 %.1699, i64 %arg.z.5.0, i64 0
  %95 = getelementptr double, ptr %arg.z.4, i64 %.1683
  %.1714 = getelementptr double, ptr %95, i64 %.1700
  %.1715 = load double, ptr %.1714, align 8
  %sunkaddr44 = mul i64 %.1164, 8
  %sunkaddr45 = getelementptr i8, ptr %126, i64 %sunkaddr44
  %.1748 = load double, ptr %sunkaddr45, align 8
  %.1750 = fmul double %.1448, %.1748
  %.1753 = fsub double %.1715, %.1750
  store double %.1753, ptr %.1714, align 8
  %scevgep87 = getelementptr i8, ptr %lsr.iv86, i64 %39
  %lsr.iv.next94 = add i64 %lsr.iv93, %arg.n
  %exitcond4.not = icmp eq i64 %.1343, %118
  br i1 %exitcond4.not, label %B260.loopexit, label %B870.preheader
B1112:                                            ; preds = %B1112.lr.ph, %B1112
  %lsr.iv16 = phi i64 [ %lsr.iv14, %B1112.lr.ph ], [ %lsr.iv.next17, %B1112 ]
  %lsr.iv47 = phi i64 [ %lsr.iv45, %B1112.lr.ph ], [ %lsr.iv.next48, %B1112 ]
  %lsr.iv41 = phi i64 [ %lsr.iv39, %B1112.lr.ph ], [ %lsr.iv.next42, %B1112 ]
  %.20701080 = phi double [ %.2069.promoted, %B1112.lr.ph ], [ %.2140, %B1112 ]
  %.2090 = icmp slt i64 %lsr.iv47, 0
  %96 = select i1 %.2090, i64 %44, i64 0
  %scevgep44 = getelementptr i8, ptr %arg.work.4, i64 %96
  %97 = shl i64 %lsr.iv47, 3
  %scevgep49 = getelementptr i8, ptr %scevgep44, i64 %97
  %.2106 = load double, ptr %scevgep49, align 8
  %.2122 = icmp slt i64 %lsr.iv41, 0
  %98 = select i1 %.2122, i64 %52, i64 0
  %scevgep38 = getelementptr i8, ptr %arg.z.4, i64 %98
  %99 = shl i64 %lsr.iv41, 3
  %scevgep43 = getelementptr i8, ptr %scevgep38, i64 %99
  %.2138 = load double, ptr %scevgep43, align 8
  %.2139 = fmul double %.2106, %.2138
  %.2140 = fsub double %.20701080, %.2139
  %sunkaddr46 = mul i64 %.2055, 8
  %sunkaddr47 = getelementptr i8, ptr %128, i64 %sunkaddr46
  store double %.2140, ptr %sunkaddr47, align 8
  %lsr.iv.next42 = add i64 %lsr.iv41, 1
  %lsr.iv.next48 = add i64 %lsr.iv47, 1
  %lsr.iv.next17 = add i64 %lsr.iv16, -1
  %.2000 = icmp sgt i64 %lsr.iv.next17, 2
  br i1 %.2000, label %B1112, label %B1208
B1208:                                            ; preds = %B1112, %B1070.endif
  %.2211.pre-phi = mul nsw i64 %.188310821088, %arg.n
  %.2192 = icmp slt i64 %.pre, 0
  %.2193 = select i1 %.2192, i64 %arg.z.5.0, i64 0
  %100 = getelementptr double, ptr %arg.z.4, i64 %.pre
  %.2207 = getelementptr double, ptr %100, i64 %.2193
  %.2208 = load double, ptr %.2207, align 8
  %.2213 = add i64 %.188310821088, %.50
  %.2215 = add i64 %.2213, %.2211.pre-phi
  %.2231 = icmp slt i64 %.2215, 0
  %.2232 = select i1 %.2231, i64 %arg.work.5.0, i64 0
  %101 = getelementptr double, ptr %arg.work.4, i64 %.2215
  %.2246 = getelementptr double, ptr %101, i64 %.2232
  %.2247 = load double, ptr %.2246, align 8
  %.2251 = fdiv double %.2208, %.2247
  store double %.2251, ptr %.2207, align 8
  %lsr.iv.next40 = add i64 %lsr.iv39, -1
  %lsr.iv.next46 = add i64 %lsr.iv45, %51
  %lsr.iv.next15 = add nuw i64 %lsr.iv14, 1
  %.1877 = icmp sgt i64 %.187610811089, 1
  br i1 %.1877, label %B1070.endif, label %B1310.preheader
B1310:                                            ; preds = %B1310.preheader.new, %B1310
  %.237710951097 = phi i64 [ 0, %B1310.preheader.new ], [ %.2384.1, %B1310 ]
  %102 = add i64 %arg.u, %.237710951097
  %.2424 = icmp slt i64 %102, 0
  %103 = select i1 %.2424, i64 %52, i64 0
  %scevgep34 = getelementptr i8, ptr %scevgep, i64 %103
  %104 = shl i64 %.237710951097, 3
  %scevgep35 = getelementptr i8, ptr %scevgep34, i64 %104
  %.2440 = load double, ptr %scevgep35, align 8
  %scevgep32 = getelementptr i8, ptr %scevgep30, i64 %104
  %scevgep33 = getelementptr i8, ptr %scevgep32, i64 -8
  %.2472 = load double, ptr %scevgep33, align 8
  %.2473 = fadd double %.2440, %.2472
  store double %.2473, ptr %scevgep35, align 8
  %.2384.1 = add nuw i64 %.237710951097, 2
  %105 = add i64 %arg.u, %.237710951097
  %106 = add i64 %105, 1
  %.2424.1 = icmp slt i64 %106, 0
  %107 = select i1 %.2424.1, i64 %134, i64 8
  %scevgep12 = getelementptr i8, ptr %scevgep, i64 %107
  %108 = shl i64 %.237710951097, 3
  %scevgep6 = getelementptr i8, ptr %scevgep12, i64 %108
  %.2440.1 = load double, ptr %scevgep6, align 8
  %.2472.1 = load double, ptr %scevgep32, align 8
  %.2473.1 = fadd double %.2440.1, %.2472.1
  store double %.2473.1, ptr %scevgep6, align 8
  %niter25.ncmp.1 = icmp eq i64 %unroll_iter16.pre-phi, %.2384.1
  br i1 %niter25.ncmp.1, label %common.ret.loopexit.unr-lcssa, label %B1310
B156.endif.loopexit.unr-lcssa:                    ; preds = %B118
  %109 = and i64 %.48, 1
  %lcmp.mod.not = icmp eq i64 %109, 0
  br i1 %lcmp.mod.not, label %B156.endif, label %B118.epil.preheader
B118.epil.preheader:                              ; preds = %B156.endif.loopexit.unr-lcssa, %B118.preheader
  %.144984986.epil.init = phi i64 [ 0, %B118.preheader ], [ %unroll_iter, %B156.endif.loopexit.unr-lcssa ]
  %.177.epil = add nsw i64 %.144984986.epil.init, %.36
  %.191.epil = icmp slt i64 %.177.epil, 0
  %.192.epil = select i1 %.191.epil, i64 %arg.work.5.0, i64 0
  %110 = getelementptr double, ptr %arg.work.4, i64 %.177.epil
  %.206.epil = getelementptr double, ptr %110, i64 %.192.epil
  %.207.epil = load double, ptr %.206.epil, align 8
  %.209.epil = add nsw i64 %.144984986.epil.init, %.50
  %.223.epil = icmp slt i64 %.209.epil, 0
  %.224.epil = select i1 %.223.epil, i64 %arg.work.5.0, i64 0
  %111 = getelementptr double, ptr %arg.work.4, i64 %.209.epil
  %.238.epil = getelementptr double, ptr %111, i64 %.224.epil
  store double %.207.epil, ptr %.238.epil, align 8
  br label %B156.endif
B156.endif:                                       ; preds = %B118.epil.preheader, %B156.endif.loopexit.unr-lcssa, %B0.endif
  %.285 = icmp sgt i64 %arg.n, 0
  %.arg.n = tail call i64 @llvm.smax.i64(i64 %arg.n, i64 0)
  br i1 %.285, label %B188.preheader, label %common.ret
B188.preheader:                                   ; preds = %B156.endif
  %112 = add nsw i64 %arg.n, -1
  %113 = icmp eq i64 %112, 0
  br i1 %113, label %B188.epil.preheader, label %B188.preheader.new
B188.preheader.new:                               ; preds = %B188.preheader
  %const = bitcast i64 9223372036854775806 to i64
  %unroll_iter11 = and i64 %arg.n, %const
  %114 = shl i64 %arg.u, 3
  %scevgep105 = getelementptr i8, ptr %arg.z.4, i64 %114
  %115 = shl i64 %arg.z.5.0, 3
  %116 = add i64 %115, 8
  br label %B188
B262.endif:                                       ; preds = %B260.loopexit, %B262.endif.preheader
  %indvars.iv = phi i64 [ %indvars.iv.next, %B260.loopexit ], [ 1, %B262.endif.preheader ]
  %lsr.iv91 = phi i64 [ %lsr.iv.next92, %B260.loopexit ], [ %36, %B262.endif.preheader ]
  %lsr.iv84 = phi ptr [ %scevgep85, %B260.loopexit ], [ %scevgep83, %B262.endif.preheader ]
  %lsr.iv71 = phi i64 [ %lsr.iv.next72, %B260.loopexit ], [ %41, %B262.endif.preheader ]
  %lsr.iv66 = phi ptr [ %scevgep67, %B260.loopexit ], [ %scevgep65, %B262.endif.preheader ]
  %lsr.iv56 = phi i64 [ %lsr.iv.next57, %B260.loopexit ], [ %37, %B262.endif.preheader ]
  %lsr.iv50 = phi i64 [ %lsr.iv.next51, %B260.loopexit ], [ %112, %B262.endif.preheader ]
  %.51710321062 = phi i64 [ %.527, %B260.loopexit ], [ %arg.n, %B262.endif.preheader ]
  %.52410331061 = phi i64 [ %.531, %B260.loopexit ], [ 0, %B262.endif.preheader ]
  %smax = call i64 @llvm.smax.i64(i64 %.51710321062, i64 0)
  %117 = add i64 %smax, %.52410331061
  %smax28 = tail call i64 @llvm.smax.i64(i64 %.51710321062, i64 0)
  %smax3 = tail call i64 @llvm.smax.i64(i64 %lsr.iv50, i64 0)
  %118 = add i64 %smax3, %indvars.iv
  %.527 = add i64 %.51710321062, -1
  %.531 = add nuw nsw i64 %.52410331061, 1
  %.602 = sub nsw i64 %arg.n, %.531
  %.603 = icmp sgt i64 %.602, 0
  br i1 %.603, label %B308.lr.ph, label %B440
B308.lr.ph:                                       ; preds = %B262.endif
  %.694 = add i64 %.52410331061, %.50
  br label %B308
B532.lr.ph:                                       ; preds = %B440
  %119 = icmp eq i64 %112, 0
  %.1003 = mul nuw nsw i64 %.52410331061, %arg.n
  %.1005 = add nsw i64 %.1003, %.50
  br i1 %119, label %B532.epil.preheader, label %B532.preheader
B532.preheader:                                   ; preds = %B532.lr.ph
  %120 = add i64 %pivot.2.1.lcssa, %40
  %121 = mul i64 %120, %39
  %scevgep61 = getelementptr i8, ptr %arg.work.4, i64 %121
  %122 = mul i64 %120, %arg.n
  br label %B532
B654.endif.unr-lcssa:                             ; preds = %B532
  br i1 %.pre-phi, label %B654.endif, label %B532.epil.preheader
B532.epil.preheader:                              ; preds = %B654.endif.unr-lcssa, %B532.lr.ph
  %.93310061008.epil.init = phi i64 [ 0, %B532.lr.ph ], [ %unroll_iter16.pre-phi, %B654.endif.unr-lcssa ]
  %.970.epil = add nsw i64 %.93310061008.epil.init, %.792
  %.984.epil = icmp slt i64 %.970.epil, 0
  %.985.epil = select i1 %.984.epil, i64 %arg.work.5.0, i64 0
  %123 = getelementptr double, ptr %arg.work.4, i64 %.970.epil
  %.999.epil = getelementptr double, ptr %123, i64 %.985.epil
  %.1000.epil = load double, ptr %.999.epil, align 8
  %.1006.epil = add nsw i64 %.93310061008.epil.init, %.1005
  %.1020.epil = icmp slt i64 %.1006.epil, 0
  %.1021.epil = select i1 %.1020.epil, i64 %arg.work.5.0, i64 0
  %124 = getelementptr double, ptr %arg.work.4, i64 %.1006.epil
  %.1035.epil = getelementptr double, ptr %124, i64 %.1021.epil
  %.1036.epil = load double, ptr %.1035.epil, align 8
  store double %.1000.epil, ptr %.1035.epil, align 8
  store double %.1036.epil, ptr %.999.epil, align 8
  br label %B654.endif
B654.endif:                                       ; preds = %B532.epil.preheader, %B654.endif.unr-lcssa
  %.1116 = add nsw i64 %pivot.2.1.lcssa, %arg.u
  %.1130 = icmp slt i64 %.1116, 0
  %.1131 = select i1 %.1130, i64 %arg.z.5.0, i64 0
  %125 = getelementptr double, ptr %arg.z.4, i64 %.1116
  %.1145 = getelementptr double, ptr %125, i64 %.1131
  %.1146 = load double, ptr %.1145, align 8
  %.1149 = add nsw i64 %.52410331061, %arg.u
  %.1163 = icmp slt i64 %.1149, 0
  %.1164 = select i1 %.1163, i64 %arg.z.5.0, i64 0
  %126 = getelementptr double, ptr %arg.z.4, i64 %.1149
  %.1178 = getelementptr double, ptr %126, i64 %.1164
  %.1179 = load double, ptr %.1178, align 8
  store double %.1146, ptr %.1178, align 8
  store double %.1179, ptr %.1145, align 8
  %.13301025.not = icmp slt i64 %.602, 1
  br i1 %.13301025.not, label %B260.loopexit, label %B764.lr.ph
B764.lr.ph:                                       ; preds = %B654.endif
  %.1414 = add nsw i64 %.1005, %.52410331061
  %.1428 = icmp slt i64 %.1414, 0
  %127 = getelementptr double, ptr %arg.work.4, i64 %.1414
  %.1375 = add i64 %.52410331061, %.50
  %sunkaddr131 = select i1 %.1428, i64 %44, i64 0
  br label %B870.preheader
B1070.endif:                                      ; preds = %B1208, %B1070.endif.preheader
  %lsr.iv14 = phi i64 [ %lsr.iv.next15, %B1208 ], [ 2, %B1070.endif.preheader ]
  %lsr.iv45 = phi i64 [ %lsr.iv.next46, %B1208 ], [ %50, %B1070.endif.preheader ]
  %lsr.iv39 = phi i64 [ %lsr.iv.next40, %B1208 ], [ %47, %B1070.endif.preheader ]
  %.187610811089 = phi i64 [ %.1886, %B1208 ], [ %.arg.n, %B1070.endif.preheader ]
  %.188310821088.in = phi i64 [ %.188310821088, %B1208 ], [ %arg.n, %B1070.endif.preheader ]
  %.188310821088 = add i64 %.188310821088.in, -1
  %.1886 = add nsw i64 %.187610811089, -1
  %.20001075.not = icmp eq i64 %arg.n, %.188310821088.in
  %.pre = add nsw i64 %.188310821088, %arg.u
  br i1 %.20001075.not, label %B1208, label %B1112.lr.ph
B1112.lr.ph:                                      ; preds = %B1070.endif
  %.2054 = icmp slt i64 %.pre, 0
  %.2055 = select i1 %.2054, i64 %arg.z.5.0, i64 0
  %128 = getelementptr double, ptr %arg.z.4, i64 %.pre
  %.2069 = getelementptr double, ptr %128, i64 %.2055
  %.2069.promoted = load double, ptr %.2069, align 8
  br label %B1112
B1310.preheader:                                  ; preds = %B1208
  %129 = icmp eq i64 %112, 0
  %130 = getelementptr double, ptr %arg.work.4, i64 %arg.n
  %131 = getelementptr i8, ptr %130, i64 48
  br i1 %129, label %B1310.epil.preheader, label %B1310.preheader.new
B1310.preheader.new:                              ; preds = %B1310.preheader
  %132 = shl i64 %arg.u, 3
  %scevgep = getelementptr i8, ptr %arg.z.4, i64 %132
  %133 = getelementptr i8, ptr %arg.work.4, i64 %39
  %scevgep30 = getelementptr i8, ptr %133, i64 56
  %134 = add i64 %52, 8
  br label %B1310
}
declare void @llvm.lifetime.start.p0(ptr)
declare i64 @strlen(ptr)
define linkonce_odr noundef i32 @f80(ptr noalias writeonly %retptr, ptr noalias readnone %excinfo, i64 %arg.address, i64 %arg.length, ptr readnone %arg.pool.0, ptr readnone %arg.pool.1, i64 %arg.pool.2, i64 %arg.pool.3, ptr %arg.pool.4, i64 %arg.pool.5.0, i64 %arg.pool.6.0, ptr readnone %arg.index.0, ptr readnone %arg.index.1, i64 %arg.index.2, i64 %arg.index.3, ptr %arg.index.4, i64 %arg.index.5.0, i64 %arg.index.6.0) {
B0.else.if:
  %.42 = add nsw i64 %arg.index.5.0, -3
  %.61 = sdiv i64 %.42, 3
  %.62 = srem i64 %.42, 3
  %.62.lobit = ashr i64 %.62, 63
  %.50.1 = add nsw i64 %.62.lobit, %.61
  %.87 = icmp eq i64 %arg.length, 0
  br i1 %.87, label %common.ret, label %B72
common.ret:                                       ; preds = %_ZN8rovbrush12orchestrator4loop5texts6_is_atB3v35B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dExx5ArrayIhLi1E1C7mutable7alignedEx.exit, %B592.endif.endif, %B538, %B474, %B72, %B0.else.if
  %.550.pre.sink = phi i64 [ %.550.pre, %B592.endif.endif ], [ -1, %B474 ], [ -1, %B72 ], [ 0, %B0.else.if ], [ -1, %B538 ], [ %.282, %_ZN8rovbrush12orchestrator4loop5texts6_is_atB3v35B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dExx5ArrayIhLi1E1C7mutable7alignedEx.exit ]
  store i64 %.550.pre.sink, ptr %retptr, align 8
  ret i32 0
B72:                                              ; preds = %B0.else.if
  %.102 = icmp ne i64 %arg.address, 0
  %.105 = icmp sgt i64 %arg.length, -1
  %or.cond.not365 = and i1 %.102, %.105
  %.118.not = icmp slt i64 %arg.length, %arg.pool.5.0
  %or.cond348 = select i1 %or.cond.not365, i1 %.118.not, i1 false
  br i1 %or.cond348, label %B40.endif.preheader.i, label %common.ret
B40.endif.preheader.i:                            ; preds = %B72
  %xtraiter.i = and i64 %arg.length, 3
  %0 = icmp ult i64 %arg.length, 4
  br i1 %0, label %B40.endif.epil.preheader.i, label %B40.endif.preheader.new.i
B40.endif.preheader.new.i:                        ; preds = %B40.endif.preheader.i
  %1 = lshr i64 %arg.length, 2
  %2 = shl nuw i64 %1, 2
  br label %B40.endif.i
common.ret.loopexit.unr-lcssa.i:                  ; preds = %B40.endif.i
  %const = bitcast i64 9223372036854775804 to i64
  %3 = and i64 %arg.length, %const
  %lcmp.mod.not.i = icmp eq i64 %xtraiter.i, 0
  br i1 %lcmp.mod.not.i, label %B138.endif, label %B40.endif.epil.preheader.i
B40.endif.epil.preheader.i:                       ; preds = %common.ret.loopexit.unr-lcssa.i, %B40.endif.preheader.i
  %hashed.2.050.epil.init.i = phi i64 [ 0, %B40.endif.preheader.i ], [ %.159.3.i, %common.ret.loopexit.unr-lcssa.i ]
  %.984648.epil.init.i = phi i64 [ 0, %B40.endif.preheader.i ], [ %3, %common.ret.loopexit.unr-lcssa.i ]
  %4 = add nsw i64 %.984648.epil.init.i, %arg.address
  br label %B40.endif.epil.i
B40.endif.epil.i:                                 ; preds = %B40.endif.epil.i, %B40.endif.epil.preheader.i
  %lsr.iv4.i = phi i64 [ %lsr.iv.next5.i, %B40.endif.epil.i ], [ %xtraiter.i, %B40.endif.epil.preheader.i ]
  %lsr.iv.i = phi i64 [ %lsr.iv.next.i, %B40.endif.epil.i ], [ %4, %B40.endif.epil.preheader.i ]
  %hashed.2.050.epil.i = phi i64 [ %.159.epil.i, %B40.endif.epil.i ], [ %hashed.2.050.epil.init.i, %B40.endif.epil.preheader.i ]
  %.5.i.epil.i = inttoptr i64 %lsr.iv.i to ptr
  %.6.i.epil.i = load i8, ptr %.5.i.epil.i, align 1
  %.7.i.epil.i = zext i8 %.6.i.epil.i to i64
  %.131.epil.i = mul nuw nsw i64 %hashed.2.050.epil.i, 16777619
  %.158.epil.i = add nuw nsw i64 %.131.epil.i, %.7.i.epil.i
  %.159.epil.i = and i64 %.158.epil.i, 4294967295
  %lsr.iv.next.i = add i64 %lsr.iv.i, 1
  %lsr.iv.next5.i = add nsw i64 %lsr.iv4.i, -1
  %epil.iter.cmp.not.i = icmp eq i64 %lsr.iv.next5.i, 0
  br i1 %epil.iter.cmp.not.i, label %B138.endif, label %B40.endif.epil.i
B40.endif.i:                                      ; preds = %B40.endif.i, %B40.endif.preheader.new.i
  %lsr.iv22 = phi i64 [ %lsr.iv.next23, %B40.endif.i ], [ %2, %B40.endif.preheader.new.i ]
  %lsr.iv6.i = phi i64 [ %8, %B40.endif.i ], [ %arg.address, %B40.endif.preheader.new.i ]
  %hashed.2.050.i = phi i64 [ %.159.3.i, %B40.endif.i ], [ 0, %B40.endif.preheader.new.i ]
  %.5.i.i = inttoptr i64 %lsr.iv6.i to ptr
  %.6.i.i = load i8, ptr %.5.i.i, align 1
  %.7.i.i = zext i8 %.6.i.i to i64
  %.131.i = mul nuw nsw i64 %hashed.2.050.i, 16777619
  %.158.i = add nuw nsw i64 %.131.i, %.7.i.i
  %5 = add i64 %lsr.iv6.i, 1
  %.5.i.1.i = inttoptr i64 %5 to ptr
  %.6.i.1.i = load i8, ptr %.5.i.1.i, align 1
  %.7.i.1.i = zext i8 %.6.i.1.i to i64
  %.131.1.i = mul i64 %.158.i, 16777619
  %.158.1.i = add i64 %.131.1.i, %.7.i.1.i
  %6 = add i64 %5, 1
  %.5.i.2.i = inttoptr i64 %6 to ptr
  %.6.i.2.i = load i8, ptr %.5.i.2.i, align 1
  %.7.i.2.i = zext i8 %.6.i.2.i to i64
  %.131.2.i = mul i64 %.158.1.i, 16777619
  %.158.2.i = add i64 %.131.2.i, %.7.i.2.i
  %7 = add i64 %6, 1
  %.5.i.3.i = inttoptr i64 %7 to ptr
  %.6.i.3.i = load i8, ptr %.5.i.3.i, align 1
  %.7.i.3.i = zext i8 %.6.i.3.i to i64
  %.131.3.i = mul i64 %.158.2.i, 16777619
  %.158.3.i = add i64 %.131.3.i, %.7.i.3.i
  %.159.3.i = and i64 %.158.3.i, 4294967295
  %lsr.iv.next23 = add i64 %lsr.iv22, -4
  %niter.ncmp.3.i = icmp eq i64 %lsr.iv.next23, 0
  %8 = add i64 %7, 1
  br i1 %niter.ncmp.3.i, label %common.ret.loopexit.unr-lcssa.i, label %B40.endif.i
B312:                                             ; preds = %B228.endif
  %9 = inttoptr i64 %arg.address to ptr
  %.58.i = icmp slt i64 %.158.i10, 0
  %.59.i = select i1 %.58.i, i64 %arg.pool.5.0, i64 0
  %10 = getelementptr i8, ptr %arg.pool.4, i64 %.158.i10
  %.73.i = getelementptr i8, ptr %10, i64 %.59.i
  %.74.i = load i8, ptr %.73.i, align 1
  %.6.i.i12 = load i8, ptr %9, align 1
  %.107.i = icmp eq i8 %.6.i.i12, %.74.i
  br i1 %.107.i, label %B82.i.preheader, label %B406
B82.i.preheader:                                  ; preds = %B312
  %11 = add i64 %.158.i10, 1
  br label %B82.i
B82.i:                                            ; preds = %B82.i.preheader, %B104.endif.i
  %lsr.iv20 = phi ptr [ %scevgep19, %B82.i.preheader ], [ %scevgep21, %B104.endif.i ]
  %lsr.iv12 = phi i64 [ %11, %B82.i.preheader ], [ %lsr.iv.next13, %B104.endif.i ]
  %lsr.iv8 = phi i64 [ %29, %B82.i.preheader ], [ %lsr.iv.next9, %B104.endif.i ]
  %12 = tail call { i64, i1 } @llvm.usub.with.overflow.i64(i64 %lsr.iv8, i64 1)
  %ov22 = extractvalue { i64, i1 } %12, 1
  br i1 %ov22, label %_ZN8rovbrush12orchestrator4loop5texts6_is_atB3v35B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dExx5ArrayIhLi1E1C7mutable7alignedEx.exit, label %B104.endif.i
B104.endif.i:                                     ; preds = %B82.i
  %.148.i = icmp slt i64 %lsr.iv12, 0
  %.149.i = select i1 %.148.i, i64 %arg.pool.5.0, i64 0
  %scevgep44 = getelementptr i8, ptr %arg.pool.4, i64 %.149.i
  %scevgep18 = getelementptr i8, ptr %scevgep44, i64 %lsr.iv12
  %.164.i = load i8, ptr %scevgep18, align 1
  %.6.i3.i = load i8, ptr %lsr.iv20, align 1
  %.195.i = icmp eq i8 %.6.i3.i, %.164.i
  %lsr.iv.next9 = add i64 %lsr.iv8, -1
  %lsr.iv.next13 = add i64 %lsr.iv12, 1
  %scevgep21 = getelementptr i8, ptr %lsr.iv20, i64 1
  br i1 %.195.i, label %B82.i, label %B406
_ZN8rovbrush12orchestrator4loop5texts6_is_atB3v35B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dExx5ArrayIhLi1E1C7mutable7alignedEx.exit: ; preds = %B82.i
  %.221.i = add nsw i64 %.158.i10, %arg.length
  %.239.i = icmp slt i64 %.221.i, 0
  %.240.i = select i1 %.239.i, i64 %arg.pool.5.0, i64 0
  %13 = getelementptr i8, ptr %arg.pool.4, i64 %.221.i
  %.254.i = getelementptr i8, ptr %13, i64 %.240.i
  %.255.i = load i8, ptr %.254.i, align 1
  %.259.i.not = icmp eq i8 %.255.i, 0
  br i1 %.259.i.not, label %common.ret, label %B406
B406:                                             ; preds = %B104.endif.i, %B228.endif, %_ZN8rovbrush12orchestrator4loop5texts6_is_atB3v35B52c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAw4hWsFpNAA_3d_3dExx5ArrayIhLi1E1C7mutable7alignedEx.exit, %B312
  %14 = icmp eq i64 %.50.1, 0
  br i1 %14, label %B406.endif, label %B406.else.if
B474:                                             ; preds = %B406.endif, %B138.endif.endif
  %cell.3.1 = phi i64 [ %rem.1.0, %B138.endif.endif ], [ %rem.2.0, %B406.endif ]
  %.579 = getelementptr i8, ptr %arg.index.4, i64 8
  %.580 = load i64, ptr %.579, align 8
  %.589 = icmp eq i64 %.550.pre, %.50.1
  br i1 %.589, label %common.ret, label %B538
B538:                                             ; preds = %B474
  %.593 = add nsw i64 %.580, %arg.length
  %.594 = add nsw i64 %.593, 1
  %.605.not = icmp slt i64 %.593, %arg.pool.5.0
  br i1 %.605.not, label %B36.endif.preheader.i, label %common.ret
B36.endif.preheader.i:                            ; preds = %B538
  %15 = icmp eq i64 %arg.length, 1
  br i1 %15, label %B36.endif.epil.preheader.i, label %B36.endif.preheader.new.i
B36.endif.preheader.new.i:                        ; preds = %B36.endif.preheader.i
  %16 = add i64 %arg.pool.5.0, 1
  %scevgep = getelementptr i8, ptr %arg.pool.4, i64 %.580
  %17 = lshr i64 %arg.length, 1
  %18 = shl nuw i64 %17, 1
  br label %B36.endif.i
common.ret.loopexit.unr-lcssa.i19:                ; preds = %B36.endif.i
  %const24 = bitcast i64 9223372036854775804 to i64
  %const_mat = add i64 %const24, 2
  %19 = and i64 %arg.length, %const_mat
  %20 = and i64 %arg.length, 1
  %lcmp.mod.not.i20 = icmp eq i64 %20, 0
  br i1 %lcmp.mod.not.i20, label %B592.endif.endif, label %B36.endif.epil.preheader.i
B36.endif.epil.preheader.i:                       ; preds = %common.ret.loopexit.unr-lcssa.i19, %B36.endif.preheader.i
  %.1127880.epil.init.i = phi i64 [ 0, %B36.endif.preheader.i ], [ %19, %common.ret.loopexit.unr-lcssa.i19 ]
  %.145.epil.i = add nsw i64 %.1127880.epil.init.i, %arg.address
  %.5.i.epil.i21 = inttoptr i64 %.145.epil.i to ptr
  %.6.i.epil.i22 = load i8, ptr %.5.i.epil.i21, align 1
  %.171.epil.i = add nsw i64 %.1127880.epil.init.i, %.580
  %.185.epil.i = icmp slt i64 %.171.epil.i, 0
  %.186.epil.i = select i1 %.185.epil.i, i64 %arg.pool.5.0, i64 0
  %21 = getelementptr i8, ptr %arg.pool.4, i64 %.171.epil.i
  %.200.epil.i = getelementptr i8, ptr %21, i64 %.186.epil.i
  store i8 %.6.i.epil.i22, ptr %.200.epil.i, align 1
  br label %B592.endif.endif
B36.endif.i:                                      ; preds = %B36.endif.i, %B36.endif.preheader.new.i
  %lsr.iv = phi i64 [ %lsr.iv.next, %B36.endif.i ], [ %18, %B36.endif.preheader.new.i ]
  %lsr.iv10 = phi ptr [ %scevgep14, %B36.endif.i ], [ %scevgep, %B36.endif.preheader.new.i ]
  %lsr.iv38 = phi i64 [ %25, %B36.endif.i ], [ %arg.address, %B36.endif.preheader.new.i ]
  %lsr.iv36 = phi i64 [ %26, %B36.endif.i ], [ %.580, %B36.endif.preheader.new.i ]
  %.5.i.i15 = inttoptr i64 %lsr.iv38 to ptr
  %.6.i.i16 = load i8, ptr %.5.i.i15, align 1
  %.185.i = icmp slt i64 %lsr.iv36, 0
  %.186.i = select i1 %.185.i, i64 %arg.pool.5.0, i64 0
  %scevgep17 = getelementptr i8, ptr %lsr.iv10, i64 %.186.i
  store i8 %.6.i.i16, ptr %scevgep17, align 1
  %22 = add i64 %lsr.iv38, 1
  %.5.i.1.i17 = inttoptr i64 %22 to ptr
  %.6.i.1.i18 = load i8, ptr %.5.i.1.i17, align 1
  %23 = add i64 %lsr.iv36, 1
  %.185.1.i = icmp slt i64 %23, 0
  %24 = select i1 %.185.1.i, i64 %16, i64 1
  %scevgep15 = getelementptr i8, ptr %lsr.iv10, i64 %24
  store i8 %.6.i.1.i18, ptr %scevgep15, align 1
  %scevgep14 = getelementptr i8, ptr %lsr.iv10, i64 2
  %lsr.iv.next = add i64 %lsr.iv, -2
  %niter.ncmp.1.i = icmp eq i64 %lsr.iv.next, 0
  %25 = add i64 %22, 1
  %26 = add i64 %23, 1
  br i1 %niter.ncmp.1.i, label %common.ret.loopexit.unr-lcssa.i19, label %B36.endif.i
B138.endif:                                       ; preds = %B40.endif.epil.i, %common.ret.loopexit.unr-lcssa.i
  %hashed.2.0.lcssa.i = phi i64 [ %.159.3.i, %common.ret.loopexit.unr-lcssa.i ], [ %.159.epil.i, %B40.endif.epil.i ]
  %.161 = shl nsw i64 %.50.1, 1
  %.164 = icmp eq i64 %.50.1, 0
  br i1 %.164, label %B138.endif.endif, label %B138.endif.else.if
B138.endif.endif:                                 ; preds = %46, %B138.endif
  %rem.1.0 = phi i64 [ 0, %B138.endif ], [ %spec.select, %46 ]
  %.209 = add nsw i64 %.50.1, 3
  %.210 = add nsw i64 %rem.1.0, %.209
  %.224 = icmp slt i64 %.210, 0
  %.225 = select i1 %.224, i64 %arg.index.5.0, i64 0
  %27 = getelementptr i64, ptr %arg.index.4, i64 %.210
  %.239 = getelementptr i64, ptr %27, i64 %.225
  %.240 = load i64, ptr %.239, align 8
  %.241.not = icmp eq i64 %.240, 0
  %.550.pre = load i64, ptr %arg.index.4, align 8
  br i1 %.241.not, label %B474, label %B228.endif.preheader
B228.endif.preheader:                             ; preds = %B138.endif.endif
  %.80.i = getelementptr i8, ptr %arg.index.4, i64 8
  %.5.i.i11 = inttoptr i64 %arg.address to ptr
  %28 = trunc i64 %.161 to i32
  %29 = add i64 %arg.length, -1
  %scevgep19 = getelementptr i8, ptr %.5.i.i11, i64 1
  br label %B228.endif
B138.endif.else.if:                               ; preds = %B138.endif
  %30 = icmp ult i64 %.161, 4294967296
  br i1 %30, label %31, label %36
31:                                               ; preds = %B138.endif.else.if
  %32 = trunc i64 %.161 to i32
  %33 = trunc i64 %hashed.2.0.lcssa.i to i32
  %34 = urem i32 %33, %32
  %35 = zext i32 %34 to i64
  br label %46
36:                                               ; preds = %B138.endif.else.if
  %37 = and i64 %.161, -4294967296
  %38 = icmp eq i64 %37, 0
  br i1 %38, label %39, label %44
39:                                               ; preds = %36
  %40 = trunc i64 %.161 to i32
  %41 = trunc i64 %hashed.2.0.lcssa.i to i32
  %42 = urem i32 %41, %40
  %43 = zext i32 %42 to i64
  br label %46
44:                                               ; preds = %36
  %45 = srem i64 %hashed.2.0.lcssa.i, %.161
  br label %46
46:                                               ; preds = %39, %44, %31
  %47 = phi i64 [ %35, %31 ], [ %43, %39 ], [ %45, %44 ]
  %.183 = icmp slt i64 %.50.1, 0
  %.184 = icmp ne i64 %47, 0
  %.185 = and i1 %.183, %.184
  %.192 = select i1 %.185, i64 %.161, i64 0
  %spec.select = add nsw i64 %.192, %47
  br label %B138.endif.endif
B228.endif:                                       ; preds = %B406.endif, %B228.endif.preheader
  %cell.2.0 = phi i64 [ %rem.2.0, %B406.endif ], [ %rem.1.0, %B228.endif.preheader ]
  %.251 = add nsw i64 %cell.2.0, %.209
  %.265 = icmp slt i64 %.251, 0
  %.266 = select i1 %.265, i64 %arg.index.5.0, i64 0
  %48 = getelementptr i64, ptr %arg.index.4, i64 %.251
  %.280 = getelementptr i64, ptr %48, i64 %.266
  %.281 = load i64, ptr %.280, align 8
  %.282 = add nsw i64 %.281, -1
  %.50.i = icmp eq i64 %.281, %.550.pre
  %.102.i = icmp slt i64 %.281, -3
  %.103.i = select i1 %.102.i, i64 %arg.index.5.0, i64 0
  %49 = getelementptr i64, ptr %arg.index.4, i64 %.282
  %50 = getelementptr i8, ptr %49, i64 32
  %.117.i = getelementptr i64, ptr %50, i64 %.103.i
  %"$phi106.0.2.0.in.i" = select i1 %.50.i, ptr %.80.i, ptr %.117.i
  %"$phi106.0.2.0.i" = load i64, ptr %"$phi106.0.2.0.in.i", align 8
  %.142.i = icmp slt i64 %.281, -2
  %.143.i = select i1 %.142.i, i64 %arg.index.5.0, i64 0
  %51 = getelementptr i8, ptr %49, i64 24
  %.157.i = getelementptr i64, ptr %51, i64 %.143.i
  %.158.i10 = load i64, ptr %.157.i, align 8
  %52 = xor i64 %.158.i10, -1
  %.162.i = add i64 %"$phi106.0.2.0.i", %52
  %.315 = icmp eq i64 %.162.i, %arg.length
  br i1 %.315, label %B312, label %B406
B406.endif:                                       ; preds = %71, %B406
  %rem.2.0 = phi i64 [ 0, %B406 ], [ %spec.select347, %71 ]
  %.481 = add nsw i64 %rem.2.0, %.209
  %.495 = icmp slt i64 %.481, 0
  %.496 = select i1 %.495, i64 %arg.index.5.0, i64 0
  %53 = getelementptr i64, ptr %arg.index.4, i64 %.481
  %.510 = getelementptr i64, ptr %53, i64 %.496
  %.511 = load i64, ptr %.510, align 8
  %.512.not = icmp eq i64 %.511, 0
  br i1 %.512.not, label %B474, label %B228.endif
B406.else.if:                                     ; preds = %B406
  %.432 = add nsw i64 %cell.2.0, 1
  %54 = or i64 %.432, %.161
  %55 = icmp ult i64 %54, 4294967296
  br i1 %55, label %56, label %60
56:                                               ; preds = %B406.else.if
  %57 = trunc i64 %.432 to i32
  %58 = urem i32 %57, %28
  %59 = zext i32 %58 to i64
  br label %71
60:                                               ; preds = %B406.else.if
  %61 = or i64 %.432, %.161
  %62 = and i64 %61, -4294967296
  %63 = icmp eq i64 %62, 0
  br i1 %63, label %64, label %69
64:                                               ; preds = %60
  %65 = trunc i64 %.161 to i32
  %66 = trunc i64 %.432 to i32
  %67 = urem i32 %66, %65
  %68 = zext i32 %67 to i64
  br label %71
69:                                               ; preds = %60
  %70 = srem i64 %.432, %.161
  br label %71
71:                                               ; preds = %64, %69, %56
  %72 = phi i64 [ %59, %56 ], [ %68, %64 ], [ %70, %69 ]
  %.455 = xor i64 %72, %.161
  %.456 = icmp slt i64 %.455, 0
  %.457 = icmp ne i64 %72, 0
  %.458 = and i1 %.457, %.456
  %.465 = select i1 %.458, i64 %.161, i64 0
  %spec.select347 = add i64 %.465, %72
  br label %B406.endif
B592.endif.endif:                                 ; preds = %B36.endif.epil.preheader.i, %common.ret.loopexit.unr-lcssa.i19
  %.230.i = icmp slt i64 %.593, 0
  %.231.i = select i1 %.230.i, i64 %arg.pool.5.0, i64 0
  %73 = getelementptr i8, ptr %arg.pool.4, i64 %.593
  %.245.i = getelementptr i8, ptr %73, i64 %.231.i
  store i8 0, ptr %.245.i, align 1
  %.675 = icmp slt i64 %.550.pre, -3
  %.676 = select i1 %.675, i64 %arg.index.5.0, i64 0
  %74 = getelementptr i64, ptr %arg.index.4, i64 %.550.pre
  %75 = getelementptr i8, ptr %74, i64 24
  %.690 = getelementptr i64, ptr %75, i64 %.676
  store i64 %.580, ptr %.690, align 8
  %.693 = add nsw i64 %.550.pre, 1
  %.699 = add nsw i64 %cell.3.1, %.209
  %.715 = icmp slt i64 %.699, 0
  %.716 = select i1 %.715, i64 %arg.index.5.0, i64 0
  %76 = getelementptr i64, ptr %arg.index.4, i64 %.699
  %.730 = getelementptr i64, ptr %76, i64 %.716
  store i64 %.693, ptr %.730, align 8
  store i64 %.693, ptr %arg.index.4, align 8
  %sunkaddr = getelementptr i8, ptr %arg.index.4, i64 8
  store i64 %.594, ptr %sunkaddr, align 8
  br label %common.ret
}
declare void @llvm.lifetime.end.p0(ptr)
declare { i64, i1 } @llvm.usub.with.overflow.i64(i64, i64)
define linkonce_odr void @NRT_decref(ptr %.1) {
.3:
  %.4 = icmp eq ptr %.1, null
  br i1 %.4, label %common.ret1, label %.3.endif
common.ret1:                                      ; preds = %.3, %.3.endif
  ret void
.3.endif:                                         ; preds = %.3
  fence release
  %0 = tail call i8 @llvm.x86.atomic.sub.cc.i64(ptr nonnull %.1, i64 1, i32 4)
  %1 = trunc i8 %0 to i1
  br i1 %1, label %.3.endif.if, label %common.ret1
.3.endif.if:                                      ; preds = %.3.endif
  fence acquire
  tail call void @NRT_MemInfo_call_dtor(ptr nonnull %.1)
  ret void
}
declare i8 @llvm.x86.atomic.sub.cc.i64(ptr, i64, i32 immarg)
declare void @NRT_MemInfo_call_dtor(ptr)
define i64 @rovbrush_loop(i64 %a, i64 %b, i64 %c, i64 %d, i64 %e, i64 %f) {
  %result = alloca i64
  %raised = alloca ptr
  store i64 -1, ptr %result
  %status = call i32 @f68(ptr %result, ptr %raised, i64 %a, i64 %b, i64 %c, i64 %d, i64 %e, i64 %f)
  %value = load i64, ptr %result
  %good = icmp eq i32 %status, 0
  %answer = select i1 %good, i64 %value, i64 -1
  ret i64 %answer
}
define i64 @rovbrush_loop_one(i64 %at) {
  %p = inttoptr i64 %at to ptr
  %p0 = getelementptr i64, ptr %p, i64 0
  %v0 = load i64, ptr %p0
  %p1 = getelementptr i64, ptr %p, i64 1
  %v1 = load i64, ptr %p1
  %p2 = getelementptr i64, ptr %p, i64 2
  %v2 = load i64, ptr %p2
  %p3 = getelementptr i64, ptr %p, i64 3
  %v3 = load i64, ptr %p3
  %p4 = getelementptr i64, ptr %p, i64 4
  %v4 = load i64, ptr %p4
  %p5 = getelementptr i64, ptr %p, i64 5
  %v5 = load i64, ptr %p5
  %answer = call i64 @rovbrush_loop(i64 %v0, i64 %v1, i64 %v2, i64 %v3, i64 %v4, i64 %v5)
  ret i64 %answer
}

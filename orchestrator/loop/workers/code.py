"""The machine code of a pool, as text for LLVM.

What one thread writes before a store of a state with `release` is seen by who reads that state with `acquire`: on
x86-64 these are plain moves, on aarch64 `stlr` and `ldar`; a job is taken by one compare-and-exchange. Workers begin
with the last job, the thread of the run with the first; while there are more, it waits for none that another has.
"""

from __future__ import annotations

import platform

from .cells import (
    CALLS,
    DONE,
    FINAL,
    FIRST,
    FLAGS,
    FMI,
    FUNCTION,
    HEAD,
    IDLE,
    INSTANCE,
    JOB,
    JOBS,
    LAST,
    LENGTH,
    MODE,
    POSTED,
    SHARED,
    SPENT,
    STATE,
    STATUS,
    STOP,
    TAKEN,
    TIME,
)

SPINS = 3000  # looks of a worker that finds nothing, before it sleeps; about 0.1 ms
SLEEP = 50_000  # ns
PAUSES = {"x86_64": "pause", "amd64": "pause", "aarch64": "yield", "arm64": "yield"}

TEXT = """
define internal ptr @cell(ptr %job, i64 %k) alwaysinline {{
  %p = getelementptr i64, ptr %job, i64 %k
  ret ptr %p
}}
define internal ptr @job(i64 %k) alwaysinline {{
  %n = mul i64 %k, {job_bytes}
  %a = add i64 %n, {jobs}
  %p = inttoptr i64 %a to ptr
  ret ptr %p
}}
define internal i64 @now() {{
  %at = alloca [2 x i64]
  %c = inttoptr i64 {clock} to ptr
  %r = call i32 %c(i32 1, ptr %at)
  %s = load i64, ptr %at
  %q = getelementptr i64, ptr %at, i64 1
  %n = load i64, ptr %q
  %m = mul i64 %s, 1000000000
  %t = add i64 %m, %n
  ret i64 %t
}}
define internal void @rest() {{
  %at = alloca [2 x i64]
  store i64 0, ptr %at
  %q = getelementptr i64, ptr %at, i64 1
  store i64 {sleep}, ptr %q
  %c = inttoptr i64 {nanosleep} to ptr
  %r = call i32 %c(ptr %at, ptr null)
  ret void
}}
define internal i32 @call(ptr %job, double %t, double %h, i32 %final, ptr %f) {{
  %pf = call ptr @cell(ptr %job, i64 {FUNCTION})
  %fn = load ptr, ptr %pf
  %pi = call ptr @cell(ptr %job, i64 {INSTANCE})
  %inst = load ptr, ptr %pi
  %pv = call ptr @cell(ptr %job, i64 {FMI})
  %v = load i64, ptr %pv
  %two = icmp eq i64 %v, 2
  br i1 %two, label %fmi2, label %fmi3
fmi2:
  %r2 = call i32 %fn(ptr %inst, double %t, double %h, i32 %final)
  ret i32 %r2
fmi3:
  %f1 = getelementptr i8, ptr %f, i64 1
  %f2 = getelementptr i8, ptr %f, i64 2
  %f8 = getelementptr i8, ptr %f, i64 8
  store i8 0, ptr %f
  store i8 0, ptr %f1
  store i8 0, ptr %f2
  %r3 = call i32 %fn(ptr %inst, double %t, double %h, i32 %final, ptr %f, ptr %f1, ptr %f2, ptr %f8)
  ret i32 %r3
}}
define internal void @answer(ptr %job, ptr %f) {{
  %pv = call ptr @cell(ptr %job, i64 {FMI})
  %v = load i64, ptr %pv
  %three = icmp eq i64 %v, 3
  br i1 %three, label %copy, label %end
copy:
  %own = call ptr @cell(ptr %job, i64 {FLAGS})
  %own8 = getelementptr i8, ptr %own, i64 8
  %f8 = getelementptr i8, ptr %f, i64 8
  %low = load i24, ptr %own
  store i24 %low, ptr %f
  %last = load double, ptr %own8
  store double %last, ptr %f8
  br label %end
end:
  ret void
}}
define internal ptr @taken() {{
begin:
  %pjobs = inttoptr i64 {count_at} to ptr
  %count = load i64, ptr %pjobs
  br label %next
next:
  %k = phi i64 [ %count, %begin ], [ %k1, %not ]
  %k1 = sub i64 %k, 1
  %left = icmp sge i64 %k1, 0
  br i1 %left, label %at, label %nothing
at:
  %job = call ptr @job(i64 %k1)
  %state = load atomic i64, ptr %job monotonic, align 8
  %is = icmp eq i64 %state, {POSTED}
  br i1 %is, label %try, label %not
try:
  %got = cmpxchg ptr %job, i64 {POSTED}, i64 {TAKEN} acquire monotonic
  %mine = extractvalue {{ i64, i1 }} %got, 1
  br i1 %mine, label %found, label %not
not:
  br label %next
found:
  ret ptr %job
nothing:
  ret ptr null
}}
define internal void @do(ptr %job) {{
  %pt = call ptr @cell(ptr %job, i64 {TIME})
  %t = load double, ptr %pt
  %ph = call ptr @cell(ptr %job, i64 {LENGTH})
  %h = load double, ptr %ph
  %pf = call ptr @cell(ptr %job, i64 {FINAL})
  %f64 = load i64, ptr %pf
  %final = trunc i64 %f64 to i32
  %flags = call ptr @cell(ptr %job, i64 {FLAGS})
  %r = call i32 @call(ptr %job, double %t, double %h, i32 %final, ptr %flags)
  %r64 = sext i32 %r to i64
  %ps = call ptr @cell(ptr %job, i64 {STATUS})
  store i64 %r64, ptr %ps
  store atomic i64 {DONE}, ptr %job release, align 8
  ret void
}}
define internal i32 @step(ptr %job, double %t, double %h, i32 %final, ptr %f) {{
  %pmode = inttoptr i64 {mode_at} to ptr
  %mode = load i64, ptr %pmode
  %shared = icmp eq i64 %mode, {SHARED}
  br i1 %shared, label %together, label %timed
timed:
  %t0 = call i64 @now()
  %rt = call i32 @call(ptr %job, double %t, double %h, i32 %final, ptr %f)
  %t1 = call i64 @now()
  %d = sub i64 %t1, %t0
  %ps = call ptr @cell(ptr %job, i64 {SPENT})
  %s0 = load i64, ptr %ps
  %s1 = add i64 %s0, %d
  store i64 %s1, ptr %ps
  %pc = call ptr @cell(ptr %job, i64 {CALLS})
  %c0 = load i64, ptr %pc
  %c1 = add i64 %c0, 1
  store i64 %c1, ptr %pc
  ret i32 %rt
together:
  %state = load atomic i64, ptr %job acquire, align 8
  %idle = icmp eq i64 %state, {IDLE}
  br i1 %idle, label %begin, label %posted
begin:
  %pfirst = call ptr @cell(ptr %job, i64 {FIRST})
  %first = load i64, ptr %pfirst
  %plast = call ptr @cell(ptr %job, i64 {LAST})
  %last = load i64, ptr %plast
  br label %more
more:
  %k = phi i64 [ %first, %begin ], [ %k1, %post ]
  %left = icmp slt i64 %k, %last
  br i1 %left, label %post, label %own
post:
  %other = call ptr @job(i64 %k)
  %ot = call ptr @cell(ptr %other, i64 {TIME})
  store double %t, ptr %ot
  %oh = call ptr @cell(ptr %other, i64 {LENGTH})
  store double %h, ptr %oh
  %of = call ptr @cell(ptr %other, i64 {FINAL})
  %final64 = zext i32 %final to i64
  store i64 %final64, ptr %of
  store atomic i64 {POSTED}, ptr %other release, align 8
  %k1 = add i64 %k, 1
  br label %more
own:
  %r = call i32 @call(ptr %job, double %t, double %h, i32 %final, ptr %f)
  ret i32 %r
posted:
  %got = cmpxchg ptr %job, i64 {POSTED}, i64 {TAKEN} acquire monotonic
  %mine = extractvalue {{ i64, i1 }} %got, 1
  br i1 %mine, label %steal, label %wait
steal:
  %rs = call i32 @call(ptr %job, double %t, double %h, i32 %final, ptr %f)
  store atomic i64 {IDLE}, ptr %job release, align 8
  ret i32 %rs
wait:
  %n = phi i64 [ 0, %posted ], [ %n1, %again ], [ 0, %help ]
  %now = load atomic i64, ptr %job acquire, align 8
  %done = icmp eq i64 %now, {DONE}
  br i1 %done, label %finished, label %look
look:
  %open = call ptr @taken()
  %none = icmp eq ptr %open, null
  br i1 %none, label %spin, label %help
help:
  call void @do(ptr %open)
  br label %wait
spin:
  %n1 = add i64 %n, 1
  %long = icmp sgt i64 %n1, {spins}
  br i1 %long, label %yield, label %pause
pause:
  call void asm sideeffect "{pause}", ""()
  br label %again
yield:
  %y = inttoptr i64 {sched_yield} to ptr
  %ry = call i32 %y()
  br label %again
again:
  br label %wait
finished:
  %pst = call ptr @cell(ptr %job, i64 {STATUS})
  %st = load i64, ptr %pst
  call void @answer(ptr %job, ptr %f)
  store atomic i64 {IDLE}, ptr %job release, align 8
  %st32 = trunc i64 %st to i32
  ret i32 %st32
}}
define void @worker() {{
begin:
  %pstop = inttoptr i64 {stop_at} to ptr
  br label %look
look:
  %idle = phi i64 [ 0, %begin ], [ %idle1, %rested ], [ 0, %found ]
  %stop = load atomic i64, ptr %pstop acquire, align 8
  %go = icmp eq i64 %stop, 0
  br i1 %go, label %scan, label %end
scan:
  %job = call ptr @taken()
  %none = icmp eq ptr %job, null
  br i1 %none, label %nothing, label %found
found:
  call void @do(ptr %job)
  br label %look
nothing:
  %idle1 = add i64 %idle, 1
  %tired = icmp sgt i64 %idle1, {spins}
  br i1 %tired, label %sleep, label %pause
pause:
  call void asm sideeffect "{pause}", ""()
  br label %rested
sleep:
  call void @rest()
  br label %rested
rested:
  br label %look
end:
  ret void
}}
"""
STUBS = {
    2: """
define i32 @step_{k}(ptr %inst, double %t, double %h, i32 %final) {{
  %j = call ptr @job(i64 {k})
  %r = call i32 @step(ptr %j, double %t, double %h, i32 %final, ptr null)
  ret i32 %r
}}
""",
    3: """
define i32 @step_{k}(ptr %inst, double %t, double %h, i32 %final, ptr %f, ptr %f1, ptr %f2, ptr %f8) {{
  %j = call ptr @job(i64 {k})
  %r = call i32 @step(ptr %j, double %t, double %h, i32 %final, ptr %f)
  ret i32 %r
}}
""",
}


def pause() -> str:
    """The instruction of this processor for who waits in a loop; empty where none is known."""
    return PAUSES.get(platform.machine().lower(), "")


def text(head: int, kinds: list[int], clock: int, nanosleep: int, sched_yield: int) -> str:
    """The code of a pool whose head is at an address and whose jobs follow; `kinds`: signatures of each, 2 or 3;
    addresses of three functions of POSIX. It has functions `step_0`, `step_1`... and `worker`."""
    common = TEXT.format(
        job_bytes=8 * JOB, jobs=head + 8 * HEAD, mode_at=head + 8 * MODE, stop_at=head + 8 * STOP,
        count_at=head + 8 * JOBS, clock=clock, nanosleep=nanosleep, sched_yield=sched_yield, sleep=SLEEP, spins=SPINS,
        pause=pause(), FUNCTION=FUNCTION, INSTANCE=INSTANCE, FMI=FMI, FLAGS=FLAGS, SPENT=SPENT, CALLS=CALLS,
        FIRST=FIRST, LAST=LAST, TIME=TIME, LENGTH=LENGTH, FINAL=FINAL, STATUS=STATUS, IDLE=IDLE, POSTED=POSTED,
        TAKEN=TAKEN, DONE=DONE, SHARED=SHARED,
    )  # fmt: skip
    assert STATE == 0  # a job is at the address of its state
    return common + "".join(STUBS[kind].format(k=k) for k, kind in enumerate(kinds))

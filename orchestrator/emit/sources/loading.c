/* @PREFIX@ has no C here: its library is loaded from the folder of resources, and its functions are found by their names.
   All instances in a process share it, as they do in any host. */
#include "@SYSTEM@_inside.h"

#include <stdatomic.h>

#if defined _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

Functions@VERSION@ @PREFIX@_functions;
@POINTERS@

static void *library; /* loaded once in a process, and never given back: somebody may be in it still */

static void *function_of(const char *name) {
#if defined _WIN32
    union {
        FARPROC function;
        void *address;
    } found;
    found.function = GetProcAddress((HMODULE)library, name);
    return found.address;
#else
    return dlsym(library, name);
#endif
}

#define FIND(name) *(void **)&@PREFIX@_fmi@VERSION@##name = function_of("fmi@VERSION@" #name), @PREFIX@_functions.name = @PREFIX@_fmi@VERSION@##name

static int load(@SYSTEM@ *s) {
    char path[3000];
    if (library) return 0;
#if defined _WIN32
    wchar_t wide[3000];
    @SYSTEM@_resource(s, "@WINDOWS@", path, sizeof path);
    for (char *c = path; *c; c++)
        if (*c == '/') *c = '\\';
    if (MultiByteToWideChar(CP_UTF8, 0, path, -1, wide, 3000)) library = (void *)LoadLibraryExW(wide, NULL, LOAD_WITH_ALTERED_SEARCH_PATH);
    if (!library)
        return @SYSTEM@_say(s, "@PREFIX@", 3, "its library %s cannot be loaded (error %lu)", path, (unsigned long)GetLastError());
#else
    @SYSTEM@_resource(s, "@LINUX@", path, sizeof path);
    library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library) return @SYSTEM@_say(s, "@PREFIX@", 3, "its library %s cannot be loaded: %s", path, dlerror());
#endif
@FOUND@
    if (!@PREFIX@_functions.DoStep || !@PREFIX@_functions.FreeInstance) {
        library = NULL;
        return @SYSTEM@_say(s, "@PREFIX@", 3, "its library %s has not the functions of FMI @VERSION@.0", path);
    }
    return 0;
}

int @PREFIX@_load(@SYSTEM@ *s) {
    static atomic_flag busy = ATOMIC_FLAG_INIT; /* hosts make instances in several threads */
    while (atomic_flag_test_and_set(&busy)) {}
    const int failed = load(s);
    atomic_flag_clear(&busy);
    return failed;
}

/* @PREFIX@ has no C here: its library is loaded from the folder of resources, and its functions are found by their names.
   All instances in a process share it, as they do in any host. */
#include "@SYSTEM@_inside.h"

#include <stdio.h>

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

/* A file in the folder of resources, which may have come as a URI. */
static void path_of(const @SYSTEM@ *s, const char *file, char *to, size_t size) {
    const char *given = s->resources ? s->resources : "";
    size_t n = 0;
    int uri = strncmp(given, "file:", 5) == 0;
    if (uri) {
        given += 5;
        if (given[0] == '/' && given[1] == '/') given += 2;
        if (given[0] != '/' && strchr(given, '/')) given = strchr(given, '/'); /* behind the name of a machine */
#if defined _WIN32
        if (given[0] == '/' && given[1] && given[2] == ':') given++;
#endif
    }
    while (*given && n + 1 < size) {
        unsigned byte;
        if (uri && given[0] == '%' && sscanf(given + 1, "%2x", &byte) == 1) to[n++] = (char)byte, given += 3;
        else to[n++] = *given++;
    }
    while (n > 1 && (to[n - 1] == '/' || to[n - 1] == '\\')) n--;
    snprintf(to + n, size - n, "/%s", file);
#if defined _WIN32
    for (char *c = to; *c; c++)
        if (*c == '/') *c = '\\';
#endif
}

#define FIND(name) *(void **)&@PREFIX@_fmi@VERSION@##name = function_of("fmi@VERSION@" #name), @PREFIX@_functions.name = @PREFIX@_fmi@VERSION@##name

int @PREFIX@_load(@SYSTEM@ *s) {
    char path[3000];
    if (library) return 0;
#if defined _WIN32
    path_of(s, "@WINDOWS@", path, sizeof path);
    library = (void *)LoadLibraryExA(path, NULL, LOAD_WITH_ALTERED_SEARCH_PATH);
    if (!library)
        return @SYSTEM@_say(s, "@PREFIX@", 3, "its library %s cannot be loaded (error %lu)", path, (unsigned long)GetLastError());
#else
    path_of(s, "@LINUX@", path, sizeof path);
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

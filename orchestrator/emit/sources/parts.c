/* The components of a system, whatever their version of FMI: made, initialized, asked, saved. */
#include "inside.h"

#include <stdio.h>

const char *SYSTEM_text_of(const SYSTEM *s, int k) { return s->texts[k] ? s->texts[k] : SYSTEM_variables[k].text; }

static int digit_of(char c) {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

static bool is_drive(const char *path) {
    return ((path[0] >= 'A' && path[0] <= 'Z') || (path[0] >= 'a' && path[0] <= 'z')) && path[1] == ':';
}

static bool is_uri(const char *text) { /* its scheme in small letters or large ones */
    static const char FILE_COLON[] = "file:";
    for (int k = 0; k < 5; k++)
        if ((text[k] | 0x20) != (FILE_COLON[k] | 0x20)) return false;
    return true;
}

/* Where the path of a URI begins: RFC 8089, and what hosts write beside it. */
static const char *path_of(const char *uri) {
    static const char LOCAL[] = "localhost/";
    const char *path = uri + 5;
    if (path[0] == '/' && path[1] == '/' && path[2] == '/') path += 2;        /* file:///x */
    else if (path[0] == '/' && path[1] == '/' && is_drive(path + 2)) path += 2; /* file://C:/x */
    else if (path[0] == '/' && path[1] == '/') {
        if (strncmp(path + 2, LOCAL, sizeof LOCAL - 1) == 0) path += 1 + sizeof LOCAL - 1;
#if !defined _WIN32
        else if (strchr(path + 2, '/')) path = strchr(path + 2, '/'); /* behind the name of a machine, which is this one */
#endif
    }
    return path[0] == '/' && is_drive(path + 1) ? path + 1 : path; /* C:/ */
}

void SYSTEM_resource(const SYSTEM *s, const char *file, char *to, size_t size) {
    const char *given = s->resources ? s->resources : "";
    const bool uri = is_uri(given);
    size_t n = 0;
    if (uri) given = path_of(given);
    while (*given && n + 1 < size) {
        const int high = uri && given[0] == '%' ? digit_of(given[1]) : -1, low = high < 0 ? -1 : digit_of(given[2]);
        if (low >= 0 && high + low > 0) to[n++] = (char)(16 * high + low), given += 3;
        else to[n++] = *given++;
    }
    while (n > 1 && (to[n - 1] == '/' || to[n - 1] == '\\')) n--;
    snprintf(to + n, size - n, "%s%s", n && file[0] ? "/" : "", file);
}

/* A path as a URI; one that is not absolute as it is. */
static void as_uri(const char *path, char *to, size_t size) {
    static const char PLAIN[] = "/:-._~";
    const bool drive = is_drive(path);
    size_t n = 0;
    if (path[0] != '/' && path[0] != '\\' && !drive) {
        snprintf(to, size, "%s", path);
        return;
    }
    snprintf(to, size, "file://%s", drive ? "/" : "");
    for (n = strlen(to); *path && n + 4 < size; path++) {
        const unsigned char c = *path == '\\' ? '/' : (unsigned char)*path;
        const bool plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || strchr(PLAIN, c);
        n += (size_t)snprintf(to + n, size - n, plain ? "%c" : "%%%02X", c);
    }
}

void SYSTEM_folder(const SYSTEM *s, int part, bool uri, char *to, size_t size) {
    char path[3000];
    to[0] = '\0';
    if (!s->resources || !s->resources[0]) return;
    SYSTEM_resource(s, SYSTEM_parts[part].folder ? SYSTEM_parts[part].folder : "", path, sizeof path - 1);
    if (uri) {
        as_uri(path, to, size);
        return;
    }
#if defined _WIN32
    for (char *c = path; *c; c++)
        if (*c == '/') *c = '\\';
    snprintf(to, size, "%s\\", path);
#else
    snprintf(to, size, "%s/", path);
#endif
}

/* The same for both; F stands for the functions of a part. */
#if SYSTEM_FMI2 && SYSTEM_FMI3
#define EITHER(two, three)                                       \
    if (SYSTEM_parts[part].version == 2) {                       \
        const Functions2 *f = SYSTEM_parts[part].functions;      \
        two;                                                     \
    } else {                                                     \
        const Functions3 *f = SYSTEM_parts[part].functions;      \
        three;                                                   \
    }
#elif SYSTEM_FMI2
#define EITHER(two, three)                                  \
    const Functions2 *f = SYSTEM_parts[part].functions;     \
    two;
#else
#define EITHER(two, three)                                  \
    const Functions3 *f = SYSTEM_parts[part].functions;     \
    three;
#endif

static int good(int status) { return (status & ~1) == 0; }

int SYSTEM_part_make(SYSTEM *s, int part) {
    EITHER(return SYSTEM_make2(s, part, f), return SYSTEM_make3(s, part, f))
}

int SYSTEM_part_set_up(SYSTEM *s, int part, double start, int with_stop, double stop) {
    const double tolerance = SYSTEM_parts[part].tolerance;
    int status = 0;
    (void)tolerance, (void)start, (void)with_stop, (void)stop;
    EITHER(status = (int)f->SetupExperiment(s->part[part], tolerance > 0.0, tolerance, start, with_stop, with_stop ? stop : 0.0),
           (void)f)
    return good(status) ? 0 : SYSTEM_refused(s, part, "be set up", status);
}

int SYSTEM_part_enter(SYSTEM *s, int part, double start, int with_stop, double stop) {
    const double tolerance = SYSTEM_parts[part].tolerance;
    int status = 0;
    (void)tolerance, (void)start, (void)with_stop, (void)stop;
    EITHER(status = (int)f->EnterInitializationMode(s->part[part]),
           status = (int)f->EnterInitializationMode(s->part[part], tolerance > 0.0, tolerance, start, with_stop != 0,
                                                    with_stop ? stop : 0.0))
    return good(status) ? 0 : SYSTEM_refused(s, part, "enter initialization", status);
}

int SYSTEM_part_leave(SYSTEM *s, int part) {
    int status = 0;
    EITHER(status = (int)f->ExitInitializationMode(s->part[part]), status = (int)f->ExitInitializationMode(s->part[part]))
    return good(status) ? 0 : SYSTEM_refused(s, part, "leave initialization", status);
}

int SYSTEM_part_terminate(SYSTEM *s, int part) {
    int status = 0;
    EITHER(status = (int)f->Terminate(s->part[part]), status = (int)f->Terminate(s->part[part]))
    return good(status) ? 0 : SYSTEM_refused(s, part, "terminate", status);
}

void SYSTEM_part_free(SYSTEM *s, int part) {
    if (!s->part[part]) return;
    EITHER(f->FreeInstance(s->part[part]), f->FreeInstance(s->part[part]))
    s->part[part] = NULL;
}

void SYSTEM_part_log(SYSTEM *s, int part, bool on) {
    if (!s->part[part]) return;
    EITHER(if (f->SetDebugLogging) f->SetDebugLogging(s->part[part], on, 0, NULL),
           if (f->SetDebugLogging) f->SetDebugLogging(s->part[part], on, 0, NULL))
}

int SYSTEM_part_give(SYSTEM *s, int k) {
    const int part = SYSTEM_variables[k].part;
    int status = 3;
    if (part < 0) return 0;
    EITHER(status = SYSTEM_give2(s, part, k, f), status = SYSTEM_give3(s, part, k, f))
    if (good(status)) return 0;
    if (status == FATAL) return SYSTEM_refused(s, part, "set a value", status);
    return SYSTEM_say(s, SYSTEM_parts[part].name, status, "%s cannot be set (status %d)", SYSTEM_variables[k].name, status);
}

int SYSTEM_part_ask(SYSTEM *s, int k, SYSTEM_Value *value) {
    const int part = SYSTEM_variables[k].part;
    int status = 3;
    EITHER(status = SYSTEM_ask2(s, part, k, f, value), status = SYSTEM_ask3(s, part, k, f, value))
    if (good(status)) return 0;
    if (status == FATAL) return SYSTEM_refused(s, part, "give a value", status);
    return SYSTEM_say(s, SYSTEM_parts[part].name, status, "%s cannot be got (status %d)", SYSTEM_variables[k].name, status);
}

int SYSTEM_part_save(SYSTEM *s, int part, void **state) {
    if (!SYSTEM_parts[part].saves || !s->part[part]) return 1;
    EITHER(return !good((int)f->GetFMUstate(s->part[part], state)), return !good((int)f->GetFMUState(s->part[part], state)))
}

int SYSTEM_part_restore(SYSTEM *s, int part, void *state) {
    if (!s->part[part]) return 1;
    EITHER(return !good((int)f->SetFMUstate(s->part[part], state)), return !good((int)f->SetFMUState(s->part[part], state)))
}

void SYSTEM_part_forget(SYSTEM *s, int part, void **state) {
    if (!*state || !s->part[part]) return; /* what is not there cannot free it */
    EITHER(f->FreeFMUstate(s->part[part], state), f->FreeFMUState(s->part[part], state))
    *state = NULL;
}

int SYSTEM_part_state_size(SYSTEM *s, int part, void *state, size_t *size) {
    if (!SYSTEM_parts[part].serializes || !s->part[part]) return 1;
    EITHER(return !good((int)f->SerializedFMUstateSize(s->part[part], state, size)),
           return !good((int)f->SerializedFMUStateSize(s->part[part], state, size)))
}

int SYSTEM_part_write(SYSTEM *s, int part, void *state, char *bytes, size_t size) {
    EITHER(return !good((int)f->SerializeFMUstate(s->part[part], state, bytes, size)),
           return !good((int)f->SerializeFMUState(s->part[part], state, (fmi3Byte *)bytes, size)))
}

int SYSTEM_part_read(SYSTEM *s, int part, const char *bytes, size_t size, void **state) {
    if (!s->part[part]) return 1;
    EITHER(return !good((int)f->DeSerializeFMUstate(s->part[part], bytes, size, state)),
           return !good((int)f->DeserializeFMUState(s->part[part], (const fmi3Byte *)bytes, size, state)))
}

/* Drives a native FMU with a recording and compares its outputs: a host of one file, with no Python.

   verify FOLDER RECORDING [RTOL [ATOL]]
     FOLDER     the unpacked FMU
     RECORDING  path without the ending: recordings/dc_motor for recordings/dc_motor_in.csv, _ref.csv, _ref.opt, ...
   An output is within where |error| <= ATOL + RTOL*its largest magnitude; RTOL is that of the recording if not given.
   Exit code: 0 all within, 1 an output is outside or a call failed, 2 wrong use or files.

   gcc -std=c11 -O2 -I FOLDER/sources verify.c -o verify -lm -ldl      cl /std:c11 /I FOLDER\sources verify.c
   For FMUs of FMI 3.0 add -DFMI3 (/DFMI3); an array x is x[1], x[2], ... in the recording.  */
#define _CRT_SECURE_NO_WARNINGS
#define _XOPEN_SOURCE 700
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef FMI3
#include "fmi3FunctionTypes.h"
#define FMI(name) fmi3##name
#define LINUX "x86_64-linux"
#define WINDOWS "x86_64-windows"
#define TOKEN "instantiationToken"
#define VALUES(values, count) (values), (count)
#define FMI_REAL(verb) fmi3##verb##Float64
#define FMI_INTEGER(verb) fmi3##verb##Int32
typedef fmi3Instance Component;
typedef fmi3Int32 Integer;
#else
#include "fmi2FunctionTypes.h"
#define FMI(name) fmi2##name
#define LINUX "linux64"
#define WINDOWS "win64"
#define TOKEN "guid"
#define VALUES(values, count) (values)
#define FMI_REAL(verb) fmi2##verb##Real
#define FMI_INTEGER(verb) fmi2##verb##Integer
typedef fmi2Component Component;
typedef fmi2Integer Integer;
#endif
typedef FMI(ValueReference) Reference;
typedef FMI(Boolean) Boolean;

#ifdef _WIN32
#include <windows.h>
#define FULL_PATH(path, full) _fullpath(full, path, sizeof full)
#define FILE_URI "file:///%s/resources"
#define LIBRARY "%s/binaries/" WINDOWS "/%s.dll"
static void *load(const char *path) { return (void *)LoadLibraryA(path); }
static void *find(void *library, const char *name) { return (void *)GetProcAddress((HMODULE)library, name); }
#else
#include <dlfcn.h>
#define FULL_PATH(path, full) realpath(path, full)
#define FILE_URI "file://%s/resources"
#define LIBRARY "%s/binaries/" LINUX "/%s.so"
static void *load(const char *path) { return dlopen(path, RTLD_NOW); }
static void *find(void *library, const char *name) { return dlsym(library, name); }
#endif

enum { LINE = 1 << 16, COLUMNS = 512 };
typedef struct {
    FILE *file;
    int count;
    size_t reference_count; /* fewer references than columns where arrays are one variable */
    char names[COLUMNS][64];
    double values[COLUMNS]; /* of the present row; [0] is the time */
    Reference references[COLUMNS];
} Series;

static void stop(int code, const char *text, const char *what) {
    fprintf(stderr, "verify: %s%s\n", text, what);
    exit(code);
}

static FILE *open_file(const char *base, const char *ending) {
    char path[1024];
    snprintf(path, sizeof path, "%s%s", base, ending);
    FILE *file = fopen(path, "rb");
    if (!file) stop(2, "cannot open ", path);
    return file;
}

static char *read_line(FILE *file) {
    static char line[LINE];
    if (!fgets(line, LINE, file)) return NULL;
    line[strcspn(line, "\r\n")] = 0;
    return line;
}

static char *read_text(const char *folder) {
    FILE *file = open_file(folder, "/modelDescription.xml");
    char *text = calloc(1, 1 << 21);
    if (!text || !fread(text, 1, (1 << 21) - 1, file)) stop(2, "cannot read modelDescription.xml in ", folder);
    fclose(file);
    return text;
}

/* Value reference of a variable and, in `type`, the first letter of its type: R(eal) or F(loat64), I(nteger), B(oolean).
   The attributes stand in the order in which these FMUs write them. In FMI 3.0 x[2] is found as x. */
static Reference look_up(const char *xml, const char *name, char *type) {
    char key[128];
#ifdef FMI3
    snprintf(key, sizeof key, " name=\"%.*s\" valueReference=\"", (int)strcspn(name, "["), name);
#else
    snprintf(key, sizeof key, " name=\"%s\" valueReference=\"", name);
#endif
    const char *at = strstr(xml, key), *element = at;
    if (!at) stop(2, "the FMU has no variable ", name);
#ifdef FMI3
    while (*element != '<') element--;
#else
    element = strchr(at, '<');
#endif
    *type = element[1];
    return (Reference)strtoul(at + strlen(key), NULL, 10);
}

static void attribute(const char *xml, const char *key, char value[256]) {
    const char *at = strstr(xml, key);
    if (!at || sscanf(at + strlen(key), "=\"%255[^\"]", value) != 1) stop(2, "modelDescription.xml lacks ", key);
}

static int next_row(Series *s) {
    char *line = read_line(s->file);
    if (!line) return 0;
    for (int k = 0; k < s->count; k++) {
        char *end;
        s->values[k] = strtod(line, &end);
        if (end == line) stop(2, "a cell is no number: ", line);
        line = end + (*end == ',');
    }
    return 1;
}

static Series *open_series(const char *xml, const char *base, const char *ending) {
    Series *s = calloc(1, sizeof *s);
    if (!s) stop(1, "not enough memory", "");
    s->file = open_file(base, ending);
    char *line = read_line(s->file), type;
    for (char *cell = line ? strtok(line, ",") : NULL; cell && s->count < COLUMNS; cell = strtok(NULL, ",")) {
        snprintf(s->names[s->count], sizeof s->names[0], "%s", cell);
        if (s->count) {
            const Reference reference = look_up(xml, cell, &type);
            if (!s->reference_count || s->references[s->reference_count - 1] != reference)
                s->references[s->reference_count++] = reference;
        }
        s->count++;
    }
    if (!s->count || !next_row(s)) stop(2, "no rows in the recording's ", ending);
    return s;
}

static double option(const char *base, const char *key) {
    FILE *file = open_file(base, "_ref.opt");
    for (char *line; (line = read_line(file));)
        if (!strncmp(line, key, strlen(key)) && strchr(line, ',')) {
            fclose(file);
            return atof(strchr(line, ',') + 1);
        }
    stop(2, "the recording's _ref.opt lacks ", key);
    return 0.0;
}

#ifdef FMI3
static void message(void *environment, fmi3Status status, fmi3String category, fmi3String text) {
    (void)environment, (void)status, (void)category;
    fprintf(stderr, "%s\n", text);
}
#else
static void message(void *environment, fmi2String instance, fmi2Status status, fmi2String category, fmi2String text, ...) {
    (void)environment, (void)status, (void)category;
    char full[1024];
    va_list arguments;
    va_start(arguments, text);
    vsnprintf(full, sizeof full, text, arguments);
    va_end(arguments);
    fprintf(stderr, "%s: %s\n", instance, full);
}
#endif

#define CALL(call) \
    if ((call) != FMI(OK)) stop(1, "failed: ", #call)
#define TYPE_OF_(name) name##TYPE
#define TYPE_OF(name) TYPE_OF_(name)
#define TEXT_OF_(name) #name
#define TEXT_OF(name) TEXT_OF_(name)
#define FUNCTION(variable, name)                                \
    variable = (TYPE_OF(name) *)find(library, TEXT_OF(name)); \
    if (!variable) stop(1, "the library lacks ", TEXT_OF(name))

static TYPE_OF(FMI_REAL(Set)) *set_real;
static TYPE_OF(FMI_INTEGER(Set)) *set_integer;
static TYPE_OF(FMI(SetBoolean)) *set_boolean;

/* The value of a variable before time 0; in FMI 3.0 the values of an array gather here until all have come. */
static struct {
    char name[64], type;
    Reference reference;
    size_t count;
    double reals[COLUMNS];
} start;

static void set_start(Component c) {
    Integer integers[COLUMNS];
    Boolean truths[COLUMNS];
    const size_t n = start.count;
    if (!n) return;
    for (size_t k = 0; k < n; k++) {
        integers[k] = (Integer)start.reals[k];
        truths[k] = start.reals[k] != 0.0;
    }
    if ((start.type == 'I'   ? set_integer(c, &start.reference, 1, VALUES(integers, n))
         : start.type == 'B' ? set_boolean(c, &start.reference, 1, VALUES(truths, n))
                             : set_real(c, &start.reference, 1, VALUES(start.reals, n))) != FMI(OK))
        stop(1, "cannot set ", start.name);
    start.count = 0;
}

/* name, causality, value, unit: parameters and the inputs of time 0 */
static void set_starts(Component c, const char *xml, const char *base) {
    FILE *file = open_file(base, "_parameters.csv");
    for (char *line = read_line(file); (line = read_line(file));) {
        const char *name = strtok(line, ","), *causality = strtok(NULL, ","), *value = strtok(NULL, ",");
        char type;
        if (!value) stop(2, "a short row in the recording's _parameters.csv: ", line);
        if (!strcmp(causality, "output")) continue;
        const Reference reference = look_up(xml, name, &type);
        if (reference != start.reference || type != start.type || start.count == COLUMNS) set_start(c);
        snprintf(start.name, sizeof start.name, "%s", name);
        start.type = type;
        start.reference = reference;
        start.reals[start.count++] = strcmp(value, "true") ? atof(value) : 1.0;
    }
    set_start(c);
    fclose(file);
}

int main(int count, char **words) {
    if (count < 3) stop(2, "usage: verify FOLDER RECORDING [RTOL [ATOL]]", "");
    const char *base = words[2], *xml = read_text(words[1]);
    char folder[4096], path[8192], name[256], token[256];
    if (!FULL_PATH(words[1], folder)) stop(2, "no folder ", words[1]);
    attribute(xml, "modelIdentifier", name);
    attribute(xml, TOKEN, token);
    snprintf(path, sizeof path, LIBRARY, folder, name);
    void *library = load(path);
    if (!library) stop(1, "cannot load (is it for this platform? does it need Python?) ", path);
    TYPE_OF(FMI(EnterInitializationMode)) *FUNCTION(enter, FMI(EnterInitializationMode));
    TYPE_OF(FMI(ExitInitializationMode)) *FUNCTION(leave, FMI(ExitInitializationMode));
    TYPE_OF(FMI_REAL(Get)) *FUNCTION(get_real, FMI_REAL(Get));
    TYPE_OF(FMI(DoStep)) *FUNCTION(do_step, FMI(DoStep));
    TYPE_OF(FMI(Terminate)) *FUNCTION(terminate, FMI(Terminate));
    TYPE_OF(FMI(FreeInstance)) *FUNCTION(release, FMI(FreeInstance));
    FUNCTION(set_real, FMI_REAL(Set));
    FUNCTION(set_integer, FMI_INTEGER(Set));
    FUNCTION(set_boolean, FMI(SetBoolean));
#ifdef FMI3
    TYPE_OF(fmi3InstantiateCoSimulation) *FUNCTION(instantiate, fmi3InstantiateCoSimulation);
    Component c = instantiate(name, token, NULL, false, true, false, false, NULL, 0, NULL, message, NULL);
#else
    TYPE_OF(fmi2Instantiate) *FUNCTION(instantiate, fmi2Instantiate);
    TYPE_OF(fmi2SetupExperiment) *FUNCTION(set_up, fmi2SetupExperiment);
    char resources[8192];
    snprintf(resources, sizeof resources, FILE_URI, folder);
    for (char *at = resources; *at; at++)
        if (*at == '\\') *at = '/';
    const fmi2CallbackFunctions callbacks = {message, calloc, free, NULL, NULL};
    Component c = instantiate(name, fmi2CoSimulation, token, resources, &callbacks, fmi2False, fmi2True);
#endif
    if (!c) stop(1, "the FMU gives no instance: ", path);

    set_starts(c, xml, base);
    Series *in = open_series(xml, base, "_in.csv"), *ref = open_series(xml, base, "_ref.csv");
    const double step = option(base, "StepSize"), rtol = count > 3 ? atof(words[3]) : option(base, "RelTol");
    const double atol = count > 4 ? atof(words[4]) : 0.0;
    double seen[COLUMNS], error[COLUMNS] = {0}, scale[COLUMNS] = {0};
#ifdef FMI3
    CALL(enter(c, false, 0.0, in->values[0], false, 0.0));
#else
    CALL(set_up(c, fmi2False, 0.0, in->values[0], fmi2False, 0.0));
    CALL(enter(c));
#endif
    CALL(leave(c));
    long steps = 0;
    for (;; steps++) {
        CALL(get_real(c, ref->references, ref->reference_count, VALUES(seen + 1, (size_t)ref->count - 1)));
        for (int k = 1; k < ref->count; k++) {
            const double difference = fabs(seen[k] - ref->values[k]);
            if (!(difference <= error[k])) error[k] = difference; /* NaN stays */
            scale[k] = fmax(scale[k], fabs(ref->values[k]));
        }
        const double now = in->values[0];
        CALL(set_real(c, in->references, in->reference_count, VALUES(in->values + 1, (size_t)in->count - 1)));
        if (!next_row(ref) || !next_row(in)) break;
        const double gap = ref->values[0] - now, size = fabs(gap - step) <= 1e-9 * fmax(step, now) ? step : gap;
#ifdef FMI3
        fmi3Boolean event, ended, early;
        double reached;
        CALL(do_step(c, now, size, true, &event, &ended, &early, &reached));
#else
        CALL(do_step(c, now, size, fmi2True));
#endif
    }
    CALL(terminate(c));
    release(c);

    int outside = 0;
    printf("%ld steps\n%-24s %12s %12s\n", steps, "output", "error", "magnitude");
    for (int k = 1; k < ref->count; k++) {
        const int within = error[k] <= atol + rtol * scale[k];
        outside += !within;
        printf("%-24s %12.3g %12.4g  %s\n", ref->names[k], error[k], scale[k],
               error[k] == 0.0 ? "equal" : within ? "within" : "outside");
    }
    return outside > 0;
}

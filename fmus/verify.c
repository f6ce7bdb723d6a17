/* Drives a native FMI 2.0 FMU with a recording and compares its outputs: a host of one file, with no Python.

   verify FOLDER RECORDING [RTOL [ATOL]]
     FOLDER     the unpacked FMU
     RECORDING  path without the ending: results/motor for results/motor_in.csv, _ref.csv, _ref.opt, _parameters.csv
   An output is within where |error| <= ATOL + RTOL*its largest magnitude; RTOL is that of the recording if not given.
   Exit code: 0 all within, 1 an output is outside or a call failed, 2 wrong use or files.

   gcc -std=c11 -O2 -I FOLDER/sources verify.c -o verify -lm -ldl      cl /std:c11 /I FOLDER\sources verify.c  */
#define _CRT_SECURE_NO_WARNINGS
#define _XOPEN_SOURCE 700
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi2FunctionTypes.h"

#ifdef _WIN32
#include <windows.h>
#define FULL_PATH(path, full) _fullpath(full, path, sizeof full)
#define FILE_URI "file:///%s/resources"
#define LIBRARY "%s/binaries/win64/%s.dll"
static void *load(const char *path) { return (void *)LoadLibraryA(path); }
static void *find(void *library, const char *name) { return (void *)GetProcAddress((HMODULE)library, name); }
#else
#include <dlfcn.h>
#define FULL_PATH(path, full) realpath(path, full)
#define FILE_URI "file://%s/resources"
#define LIBRARY "%s/binaries/linux64/%s.so"
static void *load(const char *path) { return dlopen(path, RTLD_NOW); }
static void *find(void *library, const char *name) { return dlsym(library, name); }
#endif

enum { LINE = 1 << 16, COLUMNS = 512 };
typedef struct {
    FILE *file;
    int count;
    char names[COLUMNS][64];
    double values[COLUMNS]; /* of the present row; [0] is the time */
    fmi2ValueReference references[COLUMNS];
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

/* Value reference of a variable and, in `type`, the first letter of its type: R(eal), I(nteger), B(oolean). The
   attributes stand in the order in which these FMUs write them. */
static fmi2ValueReference look_up(const char *xml, const char *name, char *type) {
    char key[128];
    snprintf(key, sizeof key, "<ScalarVariable name=\"%s\" valueReference=\"", name);
    const char *at = strstr(xml, key);
    if (!at) stop(2, "the FMU has no variable ", name);
    *type = strchr(at + 1, '<')[1];
    return (fmi2ValueReference)strtoul(at + strlen(key), NULL, 10);
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
        if (s->count) s->references[s->count] = look_up(xml, cell, &type);
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

static void message(void *environment, fmi2String instance, fmi2Status status, fmi2String category, fmi2String text, ...) {
    (void)environment, (void)status, (void)category;
    char full[1024];
    va_list arguments;
    va_start(arguments, text);
    vsnprintf(full, sizeof full, text, arguments);
    va_end(arguments);
    fprintf(stderr, "%s: %s\n", instance, full);
}

#define CALL(call) \
    if ((call) != fmi2OK) stop(1, "failed: ", #call);
#define FUNCTION(Name)                                   \
    Name##TYPE *Name = (Name##TYPE *)find(library, #Name); \
    if (!Name) stop(1, "the library lacks ", #Name)

int main(int count, char **words) {
    if (count < 3) stop(2, "usage: verify FOLDER RECORDING [RTOL [ATOL]]", "");
    const char *base = words[2], *xml = read_text(words[1]);
    char folder[4096], path[8192], resources[8192], name[256], token[256], type;
    if (!FULL_PATH(words[1], folder)) stop(2, "no folder ", words[1]);
    attribute(xml, "modelIdentifier", name);
    attribute(xml, "guid", token);
    snprintf(path, sizeof path, LIBRARY, folder, name);
    snprintf(resources, sizeof resources, FILE_URI, folder);
    for (char *at = resources; *at; at++)
        if (*at == '\\') *at = '/';
    void *library = load(path);
    if (!library) stop(1, "cannot load (is it for this platform? does it need Python?) ", path);
    FUNCTION(fmi2Instantiate);
    FUNCTION(fmi2SetupExperiment);
    FUNCTION(fmi2EnterInitializationMode);
    FUNCTION(fmi2ExitInitializationMode);
    FUNCTION(fmi2SetReal);
    FUNCTION(fmi2SetInteger);
    FUNCTION(fmi2SetBoolean);
    FUNCTION(fmi2GetReal);
    FUNCTION(fmi2DoStep);
    FUNCTION(fmi2Terminate);
    FUNCTION(fmi2FreeInstance);

    const fmi2CallbackFunctions callbacks = {message, calloc, free, NULL, NULL};
    fmi2Component c = fmi2Instantiate(name, fmi2CoSimulation, token, resources, &callbacks, fmi2False, fmi2True);
    if (!c) stop(1, "fmi2Instantiate gives no instance", "");

    /* name, causality, value, unit: parameters and the inputs of time 0 */
    FILE *file = open_file(base, "_parameters.csv");
    for (char *line = read_line(file); (line = read_line(file));) {
        const char *name = strtok(line, ","), *causality = strtok(NULL, ","), *value = strtok(NULL, ",");
        if (!value) stop(2, "a short row in the recording's _parameters.csv: ", line);
        if (!strcmp(causality, "output")) continue;
        const fmi2ValueReference reference = look_up(xml, name, &type);
        const fmi2Real real = atof(value);
        const fmi2Integer integer = (fmi2Integer)real;
        const fmi2Boolean truth = !strcmp(value, "true");
        CALL(type == 'R'   ? fmi2SetReal(c, &reference, 1, &real)
             : type == 'I' ? fmi2SetInteger(c, &reference, 1, &integer)
                           : fmi2SetBoolean(c, &reference, 1, &truth));
    }
    fclose(file);

    Series *in = open_series(xml, base, "_in.csv"), *ref = open_series(xml, base, "_ref.csv");
    const double step = option(base, "StepSize"), rtol = count > 3 ? atof(words[3]) : option(base, "RelTol");
    const double atol = count > 4 ? atof(words[4]) : 0.0;
    double seen[COLUMNS], error[COLUMNS] = {0}, scale[COLUMNS] = {0};
    CALL(fmi2SetupExperiment(c, fmi2False, 0.0, in->values[0], fmi2False, 0.0));
    CALL(fmi2EnterInitializationMode(c));
    CALL(fmi2ExitInitializationMode(c));
    long steps = 0;
    for (;; steps++) {
        CALL(fmi2GetReal(c, ref->references + 1, (size_t)ref->count - 1, seen + 1));
        for (int k = 1; k < ref->count; k++) {
            const double difference = fabs(seen[k] - ref->values[k]);
            if (!(difference <= error[k])) error[k] = difference; /* NaN stays */
            scale[k] = fmax(scale[k], fabs(ref->values[k]));
        }
        const double now = in->values[0];
        CALL(fmi2SetReal(c, in->references + 1, (size_t)in->count - 1, in->values + 1));
        if (!next_row(ref) || !next_row(in)) break;
        const double gap = ref->values[0] - now;
        CALL(fmi2DoStep(c, now, fabs(gap - step) <= 1e-9 * fmax(step, now) ? step : gap, fmi2True));
    }
    CALL(fmi2Terminate(c));
    fmi2FreeInstance(c);

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

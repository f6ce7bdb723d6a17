/* A run of @TITLE@ from its start to its stop; rows of every table as CSV, all digits.

   SYSTEM_run [FOLDER] [NAME=VALUE]...: into every_*.csv of FOLDER, or with no folder the table of the fastest rate on
   stdout. SYSTEM_run --speed: no rows, but how many times real time it is, by the processor's clock. */
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "SYSTEM.h"

typedef struct {
    const char *file;
    int columns;
    const int *cells;
    const char *const *heads; /* as CSV has them, with units */
    const char *kinds;        /* d: a double; i, u: a whole number, with and without a sign */
    int most; /* rows of a step that may be repeated */
    int64_t *kept; /* these: tick and cells of each */
    int rows;
} Table;

@TABLES@

static FILE *files[SYSTEM_TABLES];
static SYSTEM whole; /* nothing of it is on a stack or a heap */

static void message(void *user, const char *component, int status, const char *text) {
    (void)user;
    fprintf(stderr, "%s (status %d): %s\n", component, status, text);
}

/* Rows that nobody takes back any more. */
static void written(int table) {
    Table *t = &TABLES[table];
    FILE *file = files[table];
    for (int r = 0; file && r < t->rows; r++) {
        const int64_t *kept = t->kept + r * (t->columns + 1);
        fprintf(file, "%.17g", SYSTEM_time(kept[0]));
        for (int k = 0; k < t->columns; k++) {
            double number;
            memcpy(&number, &kept[k + 1], sizeof number);
            if (t->kinds[k] == 'i') fprintf(file, ",%lld", (long long)kept[k + 1]);
            else if (t->kinds[k] == 'u') fprintf(file, ",%llu", (unsigned long long)kept[k + 1]);
            else fprintf(file, ",%.17g", number);
        }
        fputc('\n', file);
    }
    t->rows = 0;
}

static void row(void *user, const SYSTEM *s, int table, int64_t tick) {
    Table *t = &TABLES[table];
    (void)user;
    if (t->rows == t->most) written(table);
    int64_t *kept = t->kept + t->rows++ * (t->columns + 1);
    kept[0] = tick;
    for (int k = 0; k < t->columns; k++) kept[k + 1] = s->now.whole[t->cells[k]];
}

static void taken_back(void *user, int table, int rows) {
    (void)user;
    TABLES[table].rows -= rows;
}

static int assigned(SYSTEM *s, char *text) {
    char *value = strchr(text, '='), *rest = value;
    *value++ = '\0';
    const int k = SYSTEM_find(text);
    if (k < 0) return fprintf(stderr, "there is no variable %s\n", text), 1;
    const SYSTEM_Kind kind = SYSTEM_variables[k].kind;
    if (kind == SYSTEM_TEXT) return SYSTEM_set_text(s, k, value);
    if (kind == SYSTEM_BOOLEAN && strcmp(value, "true") == 0) return SYSTEM_set_whole(s, k, 1);
    if (kind == SYSTEM_BOOLEAN && strcmp(value, "false") == 0) return SYSTEM_set_whole(s, k, 0);
    errno = 0;
    const double real = kind == SYSTEM_REAL ? strtod(value, &rest) : 0.0;
    const long long number = kind == SYSTEM_REAL ? 0 : strtoll(value, &rest, 10);
    if (rest == value || *rest) return fprintf(stderr, "%s=%s: a number is wanted\n", text, value), 1;
    if (errno == ERANGE && (kind != SYSTEM_REAL || fabs(real) > 1.0)) /* one that is near zero is near enough */
        return fprintf(stderr, "%s=%s: the number is too large\n", text, value), 1;
    return kind == SYSTEM_REAL ? SYSTEM_set_real(s, k, real) : SYSTEM_set_whole(s, k, number);
}

/* The folder of resources, which lies beside the program. */
static const char *resources(const char *program) {
    static char place[3000];
    const char *slash = strrchr(program, '/'), *back = strrchr(program, '\\');
    if (!slash || (back && back > slash)) slash = back;
    snprintf(place, sizeof place, "%.*sresources", slash ? (int)(slash + 1 - program) : 0, program);
    return place;
}

int main(int count, char **words) {
    SYSTEM *s = &whole;
    const char *folder = NULL;
    int speed = 0;
    if (SYSTEM_open(s, SYSTEM_TITLE, resources(count ? words[0] : ""), message, NULL)) return 1;
    for (int k = 1; k < count; k++)
        if (strcmp(words[k], "--speed") == 0) speed = 1;
        else if (!strchr(words[k], '=')) folder = words[k];
        else if (assigned(s, words[k])) return 2;
    for (int t = 0; t < SYSTEM_TABLES && !speed; t++) {
        char path[2000];
        snprintf(path, sizeof path, "%s/%s", folder ? folder : ".", TABLES[t].file);
        files[t] = folder ? fopen(path, "w") : t == 0 ? stdout : NULL;
        if (folder && !files[t]) return fprintf(stderr, "%s cannot be written\n", path), 1;
        if (!files[t]) continue;
        fprintf(files[t], "time [s]");
        for (int k = 0; k < TABLES[t].columns; k++) fprintf(files[t], ",%s", TABLES[t].heads[k]);
        fputc('\n', files[t]);
    }
    if (!speed) s->record = row, s->rewind = taken_back;
    if (SYSTEM_enter(s, SYSTEM_time(SYSTEM_START), 1, SYSTEM_time(SYSTEM_START + SYSTEM_STOP)) || SYSTEM_start(s)) return 1;
    for (int t = 0; t < SYSTEM_TABLES; t++) row(NULL, s, t, SYSTEM_START), written(t);
    int failed = 0;
    const clock_t begin = clock();
#if SYSTEM_VARIES
    failed = SYSTEM_go_to(s, s->now.time, SYSTEM_time(SYSTEM_START + SYSTEM_STOP) - s->now.time);
#else
    for (int64_t k = 0; k < SYSTEM_CYCLES && !failed; k++)
        for (int n = 1; n < SYSTEM_INSTANTS && !failed; n++) {
            failed = SYSTEM_step(s);
            for (int t = 0; t < SYSTEM_TABLES && !failed; t++) written(t);
        }
    failed = failed || (SYSTEM_LAST_INSTANTS > 1 && SYSTEM_rest(s));
#endif
    if (speed && !failed) {
        const double needed = (double)(clock() - begin) / CLOCKS_PER_SEC, done = SYSTEM_time(SYSTEM_STOP);
        printf("%.9g s in %.4f s of the processor: %.1f times real time\n", done, needed, done / needed);
    }
    for (int t = 0; t < SYSTEM_TABLES && !failed; t++) written(t);
    for (int t = 0; t < SYSTEM_TABLES; t++)
        if (files[t] && (fflush(files[t]) || ferror(files[t]))) return fprintf(stderr, "the rows cannot be written\n"), 1;
    failed = failed || SYSTEM_terminate(s);
    SYSTEM_close(s);
    return failed;
}

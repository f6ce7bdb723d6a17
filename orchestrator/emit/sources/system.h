/* @TITLE@

   @COUNTS@

   A SYSTEM is made by SYSTEM_open, is given values, and goes on from instant to instant:

       static SYSTEM s;
       SYSTEM_open(&s, "name", NULL, NULL, NULL);
       SYSTEM_set_real(&s, SYSTEM_find("motor.R"), 0.1);
       SYSTEM_enter(&s, 0.0, 1, 10.0);
       SYSTEM_start(&s);
       while (s.now.time < 10.0 && SYSTEM_step(&s) == 0) { ... SYSTEM_get_real(&s, n) ... }
       SYSTEM_close(&s);

   All functions return 0, or 1 where something went wrong, which `message` has been told then. Memory is allocated by
   the components alone, until SYSTEM_start has returned; their own code decides whether they do so later. */
#ifndef SYSTEM_H
#define SYSTEM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

@SIZES@

typedef enum { SYSTEM_REAL, SYSTEM_WHOLE, SYSTEM_BOOLEAN, SYSTEM_TEXT } SYSTEM_Kind;
typedef enum { SYSTEM_PARAMETER, SYSTEM_TUNABLE, SYSTEM_INPUT, SYSTEM_OUTPUT, SYSTEM_CALCULATED, SYSTEM_HIDDEN } SYSTEM_Causality;

typedef union {
    double real;
    int64_t whole;
} SYSTEM_Value;

/* One scalar of a component. */
typedef struct {
    const char *name, *unit;
    SYSTEM_Kind kind;
    SYSTEM_Causality causality;
    int part;           /* its component, -1: the coupling makes it */
    int type;           /* how FMI functions know it: see `Type` */
    int cell;           /* in the vector of signals, or -1 */
    unsigned reference; /* its component's */
    int index, count;   /* of an array: which element, and of how many; the elements follow each other */
    bool given;         /* the system gives it a value */
    SYSTEM_Value start;
    const char *text;
} SYSTEM_Variable;

extern const SYSTEM_Variable SYSTEM_variables[SYSTEM_VARIABLES];
extern const char *const SYSTEM_cells[SYSTEM_CELLS]; /* what each cell is, in words */

typedef enum { SYSTEM_NEW, SYSTEM_INITIALIZING, SYSTEM_RUNNING, SYSTEM_ENDED, SYSTEM_TERMINATED, SYSTEM_FAILED } SYSTEM_Stage;

#if SYSTEM_EVENTS
/* What is known to come of an event: when [ticks of SYSTEM_FINE to one of the clock], and whether its fault ends. */
typedef struct {
    int64_t time;
    int event, part, ends;
} SYSTEM_Due;
#endif

/* All that changes while it goes on, but the states of the components. */
typedef struct {
    union {
        double z[SYSTEM_CELLS]; /* all signals */
        int64_t whole[SYSTEM_CELLS];
    };
    double solver[SYSTEM_SOLVER]; /* of loops that are solved at an instant */
    SYSTEM_Value values[SYSTEM_VARIABLES]; /* what was set */
    bool given[SYSTEM_VARIABLES];
    SYSTEM_Stage stage;
    bool stale;         /* something was set, and the start is to be made consistent again */
    double stop;        /* s: no step goes beyond it */
    double time;        /* s: the instant that is reached */
    int64_t begin;      /* ticks from time 0 to the beginning of the cycle */
    int64_t first;      /* and to the start */
    int instant;        /* that is reached in the cycle */
#if SYSTEM_REPEATS || SYSTEM_VARIES
    double work[SYSTEM_WORK]; /* of the iteration, or of the choice of steps */
#endif
#if SYSTEM_VARIES
    int64_t clock[7], wanted; /* ticks: see inside.h; and the step as it would be if nothing came in its way */
#endif
#if SYSTEM_EVENTS
    SYSTEM_Due due[SYSTEM_MOST_DUE];
    int dues;
    int64_t event_at, ends_at; /* ticks from time 0: an instant at which something is due, and one behind which */
    double latest;             /* s: no step goes beyond it, to bring a component to an event */
    double reached[SYSTEM_PARTS], began[SYSTEM_PARTS]; /* s: where each is within its step, and where that part began */
    int64_t held_at, held[SYSTEM_BREAKABLE];           /* what could be held, as it was before that time */
    bool in_last;
#endif
} SYSTEM_Now;

typedef struct SYSTEM SYSTEM;
typedef void (*SYSTEM_Message)(void *user, const char *component, int status, const char *text);
typedef void (*SYSTEM_Record)(void *user, const SYSTEM *s, int table, int64_t tick);
typedef void (*SYSTEM_Rewind)(void *user, int table, int rows);

struct SYSTEM {
    SYSTEM_Now now;
    double before[SYSTEM_CELLS];
    void *part[SYSTEM_PARTS]; /* instances of the components */
    char *texts[SYSTEM_VARIABLES];
    const char *name, *resources;
    SYSTEM_Message message;
    SYSTEM_Record record; /* called with every row of a table, if it is there */
    SYSTEM_Rewind rewind; /* so many rows are taken back: their step is repeated */
    void *user;
#if SYSTEM_REPEATS
    double saved[SYSTEM_CELLS]; /* as the macro step began */
    void *kept[SYSTEM_PARTS];
#endif
    int final;      /* 1: no state before a step will be restored behind it */
    void *callbacks[8];
};

/* Make the components and give all variables their start values. `resources`: the folder of that name, where components
   have files there; `message` hears what they say, and what goes wrong. */
int SYSTEM_open(SYSTEM *s, const char *name, const char *resources, SYSTEM_Message message, void *user);
void SYSTEM_log(SYSTEM *s, bool on); /* components say what they do, and not only what goes wrong */
int SYSTEM_enter(SYSTEM *s, double start, int with_stop, double stop); /* initialization mode */
int SYSTEM_settle(SYSTEM *s);  /* values along all connections, until they are consistent */
int SYSTEM_start(SYSTEM *s);   /* the end of it: it can be stepped then */
int SYSTEM_step(SYSTEM *s);    /* to the next instant */
int SYSTEM_go_to(SYSTEM *s, double time, double step); /* from instant to instant, from `time` over `step` seconds */
int SYSTEM_rest(SYSTEM *s);    /* behind the last whole cycle, what is left to the stop that the system states */
int SYSTEM_terminate(SYSTEM *s);
void SYSTEM_close(SYSTEM *s);

double SYSTEM_time(int64_t tick);        /* s */
int64_t SYSTEM_next(const SYSTEM *s);    /* ticks from time 0 to the next instant */
int SYSTEM_find(const char *name);       /* the number of a variable, -1: there is none */

int SYSTEM_set_real(SYSTEM *s, int variable, double value);
int SYSTEM_set_whole(SYSTEM *s, int variable, int64_t value); /* whole numbers, items of enumerations, 0 and 1 */
int SYSTEM_set_text(SYSTEM *s, int variable, const char *value);
int SYSTEM_get_real(SYSTEM *s, int variable, double *value);
int SYSTEM_get_reals(SYSTEM *s, const unsigned *variables, size_t n, double *values);
int SYSTEM_get_whole(SYSTEM *s, int variable, int64_t *value);
int SYSTEM_get_text(SYSTEM *s, int variable, const char **value);

/* The complete state: what is in `now`, texts that were set, and the components' own states. */
typedef struct {
    SYSTEM_Now now;
    char *texts[SYSTEM_VARIABLES];
    void *part[SYSTEM_PARTS];
} SYSTEM_State;

int SYSTEM_save(SYSTEM *s, SYSTEM_State **state); /* into `*state` where it is one already */
int SYSTEM_restore(SYSTEM *s, SYSTEM_State *state);
void SYSTEM_forget(SYSTEM *s, SYSTEM_State **state);
int SYSTEM_state_size(SYSTEM *s, SYSTEM_State *state, size_t *size);
int SYSTEM_write_state(SYSTEM *s, SYSTEM_State *state, char *bytes, size_t size);
int SYSTEM_read_state(SYSTEM *s, const char *bytes, size_t size, SYSTEM_State **state);

#endif

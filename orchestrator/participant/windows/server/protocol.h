/* What the master and this server share: a file that both map. Its other side is memory.py and functions.py.
 *
 * The master lays down a request and counts `asked` up; the server does it and brings `answered` to the same number.
 * Both look at the numbers for a short while, then sleep on a pipe, having said so first: the other side sends a byte.
 */
#ifndef PROTOCOL_H
#define PROTOCOL_H

#include <stddef.h>
#include <stdint.h>
#include <windows.h>

enum { AREA = 1 << 20, MESSAGES = 1 << 18, FUNCTIONS = 256 };

/* What a request is. */
enum Operation { CALL, LOAD, CHUNK_FROM_SERVER, CHUNK_TO_SERVER, RESUME };

/* By their arguments behind the instance, the functions of FMI 1.0, 2.0 and 3.0 that are called here. */
enum Shape {
    SET_GET,         /* references, their number, values */
    SET_GET_SIZED,   /* the same and the number of values */
    SET_TEXT, SET_TEXT_SIZED, GET_TEXT, GET_TEXT_SIZED,
    STEP,            /* time, length, a flag */
    STEP3,           /* time, length, a flag, where three flags and a time go */
    STATE_OUT,       /* where a state is, or goes */
    STATE_IN,        /* a state */
    STATE_SIZE,      /* a state, where its size goes */
    SERIALIZE,       /* a state, where its bytes go, their number */
    DESERIALIZE,     /* bytes, their number, where the state goes */
    PLAIN,           /* nothing */
    FREE,            /* nothing, and no answer */
    EXPERIMENT,      /* tolerance defined, tolerance, start, stop defined, stop */
    INITIALIZE1,     /* start, stop defined, stop */
    LOGGING,         /* on, number of categories, categories */
    LOGGING1,        /* on */
    STATUS_NUMBER,   /* kind, where the number goes */
    STATUS_TEXT,     /* kind, where the text goes */
    TEXT,            /* no instance either; the answer is a text */
    INSTANTIATE1, INSTANTIATE2, INSTANTIATE3,
    /* of events: events.c; arrays lie in the values, 8 bytes an element, one behind the other */
    SET_BINARY, GET_BINARY,   /* references, their number, sizes, where the bytes are, number of values */
    PAIRS, TRIPLES,  /* references, their number, two or three arrays */
    UPDATE,          /* where five flags and a time go */
    ACTIVATE,        /* a reference, a time */
    INSTANTIATE_SCHEDULED,
    /* of Model Exchange: exchange.c */
    TIME,            /* a time */
    VECTOR,          /* an array, its length */
    COMPLETED2, COMPLETED3, /* a flag, where two go */
    EVENT_INFO,      /* where an fmi2EventInfo goes */
    COUNT,           /* where a number goes */
    DIRECTIONAL2, DIRECTIONAL3, /* references, their number, of unknowns and of knowns; seeds, where the answer goes */
    INSTANTIATE_MODEL
};

/* As `channel.CALL`: of set, get and step; a state goes through the first eight bytes of the values. */
struct Call {
    uint16_t function;
    uint64_t references, values;
    double time, length;
    uint8_t final;
};

struct Shared {
    /* what a master lays down for an isolated FMU of its own platform too: see channel.py */
    unsigned char references[AREA], values[AREA];
    char texts[AREA];
    /* a page of numbers */
    volatile uint32_t asked, answered, server_sleeps, master_sleeps;
    uint32_t operation;
    int32_t status;          /* of the FMU */
    uint32_t written;        /* bytes in `messages` */
    uint32_t kept_back;      /* messages that were not wanted, or had no room */
    int32_t allowance;       /* messages that may still pass */
    int32_t lowest;          /* status of a message that is wanted */
    uint32_t crash;          /* the code of an exception that ends the process */
    uint32_t refused;        /* why the library is not loaded: a code of Windows */
    struct Call call;
    uint64_t words[8];       /* other arguments; doubles by their bits */
    uint64_t result;         /* a pointer or a size */
    uint64_t inside;         /* whether a function waits for the master in the middle of a call, until RESUME */
    unsigned char page[4096 - 12 * 4 - sizeof(struct Call) - 10 * 8];
    char messages[MESSAGES]; /* for each its status (4 bytes), category and text, both ended by 0 */
};

extern struct Shared *shared;
extern void *instance;

typedef void (*Function)(void);

/* Load the library whose path is the first text; the others are the names of functions, by number. */
void load(void);
/* Call the function of a request. */
void call(void);
/* A part of a serialized state: words[0] is where it begins, words[1] its length, words[2] the length of all. */
void chunk(enum Operation operation);

/* Those kinds that are not of calls.c: the FMU's status. */
int event_call(Function f, enum Shape shape);
int exchange_call(Function f, enum Shape shape);
/* An instance for scheduled execution, and one for Model Exchange of FMI 3.0, of the texts that lie in `texts`. */
void *instantiate_scheduled(Function f);
void *instantiate_model(Function f);
/* Let the master make calls in the middle of one, until it has had enough. */
void let_master_call(void);

/* The next of the texts that lie in `texts` one behind the other, from `*at` on. */
const char *next_text(size_t *at);
/* A number of `words` as a double. */
double real(uint64_t word);
/* A message to the master. */
void say(int status, const char *category, const char *text);
/* Loggers: FMI 1.0 and 2.0, FMI 3.0. */
void logger(void *environment, const char *name, int status, const char *category, const char *message, ...);
void logger3(void *environment, int status, const char *category, const char *message);

#endif

/* What an FMU logs, on its way to the master; what nobody wants is counted only. */
#include "protocol.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { LONGEST = 1 << 16 };

static CRITICAL_SECTION one_at_a_time; /* an FMU may log from threads of its own */
static LONG ready;

static int wanted(int status)
{
    if (status >= shared->lowest && shared->allowance > 0) {
        shared->allowance--;
        return 1;
    }
    shared->kept_back++;
    return 0;
}

static void put(int status, const char *category, const char *text)
{
    size_t first = strlen(category) + 1, second = strlen(text) + 1, at = shared->written;
    if (at + 4 + first + second > MESSAGES) {
        shared->kept_back++;
        return;
    }
    memcpy(shared->messages + at, &status, 4);
    memcpy(shared->messages + at + 4, category, first);
    memcpy(shared->messages + at + 4 + first, text, second);
    shared->written = (uint32_t)(at + 4 + first + second);
}

static void enter(void)
{
    if (InterlockedCompareExchange(&ready, 1, 0) == 0) {
        InitializeCriticalSection(&one_at_a_time);
        ready = 2;
    }
    while (ready != 2)
        Sleep(0);
    EnterCriticalSection(&one_at_a_time);
}

void say(int status, const char *category, const char *text)
{
    enter();
    put(status, category ? category : "", text ? text : "");
    LeaveCriticalSection(&one_at_a_time);
}

void logger(void *environment, const char *name, int status, const char *category, const char *message, ...)
{
    static char text[LONGEST];
    va_list arguments;
    (void)environment, (void)name;
    enter();
    if (wanted(status)) {
        va_start(arguments, message);
        vsnprintf(text, sizeof text, message ? message : "", arguments);
        va_end(arguments);
        text[sizeof text - 1] = 0;
        put(status, category ? category : "", text);
    }
    LeaveCriticalSection(&one_at_a_time);
}

void logger3(void *environment, int status, const char *category, const char *message)
{
    (void)environment;
    enter();
    if (wanted(status))
        put(status, category ? category : "", message ? message : "");
    LeaveCriticalSection(&one_at_a_time);
}

/* server.exe FILE: an FMU for Windows, served to a master on Linux. FILE is mapped by both; see protocol.h.
 *
 * Standard input and output are pipes for single bytes that wake up who sleeps. It ends when its input does.
 */
#include "protocol.h"

#include <io.h>
#include <stdio.h>

enum { LOOKING = 200, LOOKS = 64 }; /* us that it looks for a request at most; looks before others may run */

struct Shared *shared;
void *instance;
static HANDLE input, output;
static LONGLONG looking, longest; /* in ticks of the clock */
static uint32_t number = 1;       /* of the request that is to be done next, or is being done */

static LONG WINAPI crashed(EXCEPTION_POINTERS *what)
{
    shared->crash = what->ExceptionRecord->ExceptionCode;
    TerminateProcess(GetCurrentProcess(), 99);
    return EXCEPTION_EXECUTE_HANDLER;
}

/* Wait for the request with a number. It is looked for as long as that pays: longer where the last one came in time,
 * not so long where it did not, because the processor is wanted or the master is busy. */
static void wait_for_request(void)
{
    LARGE_INTEGER now, begin;
    char byte;
    DWORD came;
    QueryPerformanceCounter(&begin);
    for (int turn = 0; shared->asked != number; turn++) {
        for (int k = 0; k < LOOKS && shared->asked != number; k++)
            YieldProcessor();
        if (shared->asked == number)
            break;
        QueryPerformanceCounter(&now);
        if (now.QuadPart - begin.QuadPart < looking) {
            SwitchToThread(); /* the master may need this very processor */
            continue;
        }
        looking = looking / 2 > longest / 16 ? looking / 2 : longest / 16;
        do {
            shared->server_sleeps = 1;
            MemoryBarrier();
            if (shared->asked != number && (!ReadFile(input, &byte, 1, &came, NULL) || came == 0))
                ExitProcess(0); /* the master has gone */
            shared->server_sleeps = 0;
        } while (shared->asked != number);
        return;
    }
    looking = 2 * looking < longest ? 2 * looking : longest;
}

static void answer(void)
{
    DWORD went;
    MemoryBarrier();
    shared->answered = number;
    MemoryBarrier();
    if (shared->master_sleeps)
        WriteFile(output, "", 1, &went, NULL);
}

static void serve(void)
{
    switch (shared->operation) {
    case CALL:
        call();
        break;
    case LOAD:
        load();
        break;
    default:
        chunk(shared->operation);
    }
}

void let_master_call(void)
{
    shared->inside = 1;
    for (answer();; answer()) {
        number++;
        wait_for_request();
        if (shared->operation == RESUME)
            break; /* the call that it was in the middle of is its answer */
        serve();
    }
    shared->inside = 0;
}

/* A standard handle that stays open when the C library closes its own. */
static HANDLE own(DWORD which)
{
    HANDLE found = NULL, here = GetCurrentProcess();
    DuplicateHandle(here, GetStdHandle(which), here, &found, 0, FALSE, DUPLICATE_SAME_ACCESS);
    return found;
}

int main(int count, char **arguments)
{
    LARGE_INTEGER frequency;
    ULONG stack = 1 << 16;
    HANDLE file, mapping;
    if (count != 2)
        return 2;
    file = CreateFileA(arguments[1], GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, NULL,
                       OPEN_EXISTING, 0, NULL);
    mapping = file == INVALID_HANDLE_VALUE ? NULL : CreateFileMappingA(file, NULL, PAGE_READWRITE, 0, 0, NULL);
    shared = mapping ? MapViewOfFile(mapping, FILE_MAP_ALL_ACCESS, 0, 0, sizeof *shared) : NULL;
    if (!shared) {
        fprintf(stderr, "%s cannot be mapped (error %lu)\n", arguments[1], GetLastError());
        return 3;
    }
    input = own(STD_INPUT_HANDLE), output = own(STD_OUTPUT_HANDLE);
    /* What the FMU reads and prints is not in the way of the pipes, whichever C library it has. */
    freopen("NUL", "r", stdin);
    _dup2(2, 1);
    setvbuf(stdout, NULL, _IONBF, 0);
    SetStdHandle(STD_INPUT_HANDLE, NULL);
    SetStdHandle(STD_OUTPUT_HANDLE, GetStdHandle(STD_ERROR_HANDLE));
    SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX | SEM_NOOPENFILEERRORBOX); /* no windows that wait */
    SetThreadStackGuarantee(&stack);
    SetUnhandledExceptionFilter(crashed);
    QueryPerformanceFrequency(&frequency);
    looking = longest = frequency.QuadPart * LOOKING / 1000000;
    for (;; number++) {
        wait_for_request();
        serve();
        answer();
    }
}

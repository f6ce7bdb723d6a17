/* The complete state of a system, kept or as bytes: what changes in it, and the states of its components. */
#include "inside.h"

#include <stdlib.h>

static const char TOKEN[] = "@TOKEN@";
#define NO_TEXT UINT64_MAX /* the length of one that was not set */

static bool is_text(int k) { return SYSTEM_variables[k].kind == SYSTEM_TEXT; }

static bool copied(char **to, const char *text) {
    free(*to);
    *to = text ? malloc(strlen(text) + 1) : NULL;
    if (*to) strcpy(*to, text);
    return *to || !text;
}

/* So that bytes that were damaged are known: Fowler, Noll, Vo, FNV-1a of 64 bits. */
static uint64_t sum_of(const char *bytes, size_t size) {
    uint64_t sum = UINT64_C(0xcbf29ce484222325);
    for (size_t k = 0; k < size; k++) sum = (sum ^ (unsigned char)bytes[k]) * UINT64_C(0x100000001b3);
    return sum;
}

int SYSTEM_save(SYSTEM *s, SYSTEM_State **state) {
    const bool fresh = *state == NULL;
    if (fresh) *state = calloc(1, sizeof **state);
    if (!*state) return SYSTEM_say(s, s->name, 3, "not enough memory for a state");
    (*state)->now = s->now;
    for (int k = 0; k < SYSTEM_VARIABLES; k++)
        if (is_text(k) && !copied(&(*state)->texts[k], s->texts[k])) {
            if (fresh) SYSTEM_forget(s, state);
            return SYSTEM_say(s, s->name, 3, "not enough memory for a state");
        }
    for (int part = 0; part < SYSTEM_PARTS; part++)
        if (SYSTEM_part_save(s, part, &(*state)->part[part])) {
            if (fresh) SYSTEM_forget(s, state);
            return SYSTEM_say(s, SYSTEM_parts[part].name, 3, "%s cannot save its state", SYSTEM_parts[part].name);
        }
    return 0;
}

int SYSTEM_restore(SYSTEM *s, SYSTEM_State *state) {
    if (!state) return SYSTEM_say(s, s->name, 3, "there is no state to restore");
    for (int part = 0; part < SYSTEM_PARTS; part++)
        if (SYSTEM_part_restore(s, part, state->part[part])) {
            s->now.stage = SYSTEM_FAILED; /* those before it are where the state is, those behind it are not */
            return SYSTEM_say(s, SYSTEM_parts[part].name, 3, "%s cannot restore its state", SYSTEM_parts[part].name);
        }
    s->now = state->now;
    for (int k = 0; k < SYSTEM_VARIABLES; k++)
        if (is_text(k) && !copied(&s->texts[k], state->texts[k])) return SYSTEM_fail(s, s->name, 3, "not enough memory for a text");
    return 0;
}

void SYSTEM_forget(SYSTEM *s, SYSTEM_State **state) {
    if (!state || !*state) return;
    for (int k = 0; k < SYSTEM_VARIABLES; k++) free((*state)->texts[k]);
    for (int part = 0; part < SYSTEM_PARTS; part++) SYSTEM_part_forget(s, part, &(*state)->part[part]);
    free(*state);
    *state = NULL;
}

int SYSTEM_state_size(SYSTEM *s, SYSTEM_State *state, size_t *size) {
    if (!state) return SYSTEM_say(s, s->name, 3, "there is no state to write");
    *size = sizeof TOKEN + sizeof state->now + sizeof(uint64_t);
    for (int k = 0; k < SYSTEM_VARIABLES; k++)
        if (is_text(k)) *size += sizeof(uint64_t) + (state->texts[k] ? strlen(state->texts[k]) : 0);
    for (int part = 0; part < SYSTEM_PARTS; part++) {
        size_t own = 0;
        if (SYSTEM_part_state_size(s, part, state->part[part], &own))
            return SYSTEM_say(s, SYSTEM_parts[part].name, 3, "%s cannot write its state", SYSTEM_parts[part].name);
        *size += sizeof(uint64_t) + own;
    }
    return 0;
}

int SYSTEM_write_state(SYSTEM *s, SYSTEM_State *state, char *bytes, size_t size) {
    const char *const begin = bytes;
    size_t needed;
    if (SYSTEM_state_size(s, state, &needed)) return 1;
    if (size < needed) return SYSTEM_say(s, s->name, 3, "a state needs %lu bytes", (unsigned long)needed);
    memcpy(bytes, TOKEN, sizeof TOKEN), bytes += sizeof TOKEN;
    memcpy(bytes, &state->now, sizeof state->now), bytes += sizeof state->now;
    for (int k = 0; k < SYSTEM_VARIABLES; k++) {
        if (!is_text(k)) continue;
        const uint64_t length = state->texts[k] ? strlen(state->texts[k]) : NO_TEXT;
        memcpy(bytes, &length, sizeof length), bytes += sizeof length;
        if (state->texts[k]) memcpy(bytes, state->texts[k], (size_t)length), bytes += length;
    }
    for (int part = 0; part < SYSTEM_PARTS; part++) {
        size_t own = 0;
        if (SYSTEM_part_state_size(s, part, state->part[part], &own)) return 1;
        const uint64_t length = own;
        memcpy(bytes, &length, sizeof length), bytes += sizeof length;
        if (SYSTEM_part_write(s, part, state->part[part], bytes, own)) return SYSTEM_say(s, s->name, 3, "a state cannot be written");
        bytes += own;
    }
    const uint64_t sum = sum_of(begin, (size_t)(bytes - begin));
    memcpy(bytes, &sum, sizeof sum);
    return 0;
}

static bool plausible(const SYSTEM_Now *now) {
#if SYSTEM_EVENTS
    if (now->dues < 0 || now->dues > SYSTEM_MOST_DUE) return false;
#endif
    return now->instant >= 0 && now->instant < SYSTEM_INSTANTS && (int)now->stage >= 0 && now->stage <= SYSTEM_FAILED;
}

int SYSTEM_read_state(SYSTEM *s, const char *bytes, size_t size, SYSTEM_State **state) {
    const size_t least = sizeof TOKEN + sizeof(SYSTEM_Now) + sizeof(uint64_t);
    const char *const end = bytes + (size < least ? 0 : size - sizeof(uint64_t));
    uint64_t sum;
    SYSTEM_State *found = calloc(1, sizeof *found);
    if (!found) return SYSTEM_say(s, s->name, 3, "not enough memory for a state");
    if (!bytes || size < least || memcmp(bytes, TOKEN, sizeof TOKEN) != 0) goto refused;
    memcpy(&sum, end, sizeof sum);
    if (sum != sum_of(bytes, size - sizeof sum)) goto refused;
    bytes += sizeof TOKEN;
    memcpy(&found->now, bytes, sizeof found->now), bytes += sizeof found->now;
    if (!plausible(&found->now)) goto refused;
    for (int k = 0; k < SYSTEM_VARIABLES; k++) {
        uint64_t length;
        if (!is_text(k)) continue;
        if ((size_t)(end - bytes) < sizeof length) goto refused;
        memcpy(&length, bytes, sizeof length), bytes += sizeof length;
        if (length == NO_TEXT) continue;
        if ((uint64_t)(end - bytes) < length || !(found->texts[k] = calloc(1, (size_t)length + 1))) goto refused;
        memcpy(found->texts[k], bytes, (size_t)length), bytes += length;
    }
    for (int part = 0; part < SYSTEM_PARTS; part++) {
        uint64_t own;
        if ((size_t)(end - bytes) < sizeof own) goto refused;
        memcpy(&own, bytes, sizeof own), bytes += sizeof own;
        if ((uint64_t)(end - bytes) < own || SYSTEM_part_read(s, part, bytes, (size_t)own, &found->part[part])) goto refused;
        bytes += own;
    }
    if (bytes != end) goto refused;
    if (*state) SYSTEM_forget(s, state);
    *state = found;
    return 0;
refused:
    SYSTEM_forget(s, &found);
    return SYSTEM_say(s, s->name, 3, "these bytes are no state of %s", SYSTEM_TITLE);
}

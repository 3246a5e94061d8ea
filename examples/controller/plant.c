/* SPDX-License-Identifier: BSD-2-Clause */
#define _POSIX_C_SOURCE 200809L
#include "plant.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/utsname.h>

typedef void *instance;
typedef instance instantiate(const char *, const char *, const char *, bool, bool, bool, bool,
                             const uint32_t *, size_t, void *, void *, void *);
typedef int get_numbers(instance, const uint32_t *, size_t, double *, size_t);
typedef int set_numbers(instance, const uint32_t *, size_t, const double *, size_t);
typedef int enter(instance, bool, double, double, bool, double);
typedef int leave(instance);
typedef int do_step(instance, double, double, bool, bool *, bool *, bool *, double *);

struct plant {
    void *library;
    instance unit;
    get_numbers *get;
    set_numbers *set;
    do_step *step;
    double time;
    uint32_t force[TENDONS], start[JOINTS], q[JOINTS], qd[JOINTS]; /* value references */
};

static void *loaded(plant *p, const char *name)
{
    void *symbol = dlsym(p->library, name);
    if (!symbol) fprintf(stderr, "the unit has no %s\n", name);
    return symbol;
}

static char *text_of(const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/modelDescription.xml", folder);
    FILE *file = fopen(path, "r");
    if (!file) return 0;
    char *text = calloc(1, 1 << 20);
    if (text && fread(text, 1, (1 << 20) - 1, file) == 0) text[0] = 0;
    fclose(file);
    return text;
}

/* The value of an attribute after `from`; the description is written by sinew, so that a search for
 * the text is enough. */
static void attribute(const char *from, const char *name, char *to, size_t size)
{
    char wanted[64];
    snprintf(wanted, sizeof wanted, "%s=\"", name);
    const char *at = from ? strstr(from, wanted) : 0;
    to[0] = 0;
    if (!at) return;
    at += strlen(wanted);
    snprintf(to, size, "%.*s", (int)strcspn(at, "\""), at);
}

static uint32_t reference(const char *text, const char *variable)
{
    char wanted[64], number[16];
    snprintf(wanted, sizeof wanted, "<Float64 name=\"%s\"", variable);
    attribute(strstr(text, wanted), "valueReference", number, sizeof number);
    return (uint32_t)strtoul(number, 0, 10);
}

static void find_variables(plant *p, const char *text)
{
    char name[32];
    for (int i = 0; i < TENDONS; ++i) {
        snprintf(name, sizeof name, "tendon_force.h%d", i + 1);
        p->force[i] = reference(text, name);
    }
    for (int i = 0; i < JOINTS; ++i) {
        snprintf(name, sizeof name, "q_start.q2%d", i);
        p->start[i] = reference(text, name);
        snprintf(name, sizeof name, "q.q2%d", i);
        p->q[i] = reference(text, name);
        snprintf(name, sizeof name, "qd.q2%d", i);
        p->qd[i] = reference(text, name);
    }
}

static int start(plant *p, const char *folder, const char *text, const double q[JOINTS])
{
    char path[4096], token[128], identifier[64];
    struct utsname machine;
    attribute(text, "instantiationToken", token, sizeof token);
    attribute(text, "modelIdentifier", identifier, sizeof identifier);
    uname(&machine);
    snprintf(path, sizeof path, "%s/binaries/%s-linux/%s.so", folder, machine.machine, identifier);
    p->library = dlopen(path, RTLD_NOW);
    if (!p->library) return fprintf(stderr, "%s\n", dlerror()), 0;
    instantiate *make = (instantiate *)loaded(p, "fmi3InstantiateCoSimulation");
    enter *begin = (enter *)loaded(p, "fmi3EnterInitializationMode");
    leave *end = (leave *)loaded(p, "fmi3ExitInitializationMode");
    p->get = (get_numbers *)loaded(p, "fmi3GetFloat64");
    p->set = (set_numbers *)loaded(p, "fmi3SetFloat64");
    p->step = (do_step *)loaded(p, "fmi3DoStep");
    if (!make || !begin || !end || !p->get || !p->set || !p->step) return 0;
    p->unit = make("finger", token, 0, false, false, false, false, 0, 0, 0, 0, 0);
    find_variables(p, text);
    return p->unit && begin(p->unit, false, 0, 0, false, 0) == 0 &&
           p->set(p->unit, p->start, JOINTS, q, JOINTS) == 0 && end(p->unit) == 0;
}

plant *plant_open(const char *folder, const double q[JOINTS])
{
    char *text = text_of(folder);
    plant *p = calloc(1, sizeof *p);
    const int ready = text && p && start(p, folder, text, q);
    if (!text) fprintf(stderr, "%s holds no modelDescription.xml\n", folder);
    free(text);
    if (ready) return p;
    free(p);
    return 0;
}

void plant_close(plant *p)
{
    void (*release)(instance) = (void (*)(instance))loaded(p, "fmi3FreeInstance");
    if (release) release(p->unit);
    dlclose(p->library);
    free(p);
}

void plant_read(plant *p, double q[JOINTS], double qd[JOINTS])
{
    p->get(p->unit, p->q, JOINTS, q, JOINTS);
    p->get(p->unit, p->qd, JOINTS, qd, JOINTS);
}

int plant_step(plant *p, const double f[TENDONS], double step)
{
    bool event, terminate, early;
    double reached;
    if (p->set(p->unit, p->force, TENDONS, f, TENDONS) != 0 ||
        p->step(p->unit, p->time, step, true, &event, &terminate, &early, &reached) != 0)
        return 0;
    p->time = reached;
    return 1;
}

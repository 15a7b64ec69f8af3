/* SPDX-License-Identifier: MIT
   A plant for tests: y = gain * u, n counts the steps, b says whether y is above 10.
   FMI_2 builds it for FMI 2.0, else for FMI 3.0. Its token is {1}. fault: 1 fails in a step, 2 wants to end, 3 ends
   the process, 4 does not return,
   5 is late. */
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    double u, y, gain;
    int32_t n, fault, small;
    bool b;
    void *environment;
    void *log;
    const char *name;
} Plant;

#ifdef FMI_2
typedef int Truth;
typedef void (*Log)(void *, const char *, int, const char *, const char *, ...);
typedef struct {
    Log log;
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void *finished, *environment;
} Callbacks;
#define API(name) fmi2##name
#define COUNT
#else
typedef bool Truth;
typedef void (*Log)(void *, int, const char *, const char *);
#define API(name) fmi3##name
#define COUNT , size_t values
#endif

static void *plant(void *environment, Log log, const char *name) {
    Plant *p = calloc(1, sizeof(Plant));
    p->gain = 1.0;
    p->environment = environment;
    p->log = (void *)log;
    p->name = name;
    return p;
}

static void *refused(void *environment, Log log, const char *name, const char *token) {
#ifdef FMI_2
    log(environment, name, 3, "error", "made for another token than %s", token);
#else
    log(environment, 3, "error", "made for another token");
#endif
    return NULL;
}

static int failed(Plant *p, const char *text) {
#ifdef FMI_2
    ((Log)p->log)(p->environment, "plant", 3, "error", text);
#else
    ((Log)p->log)(p->environment, 3, "error", text);
#endif
    return 3;
}

static int step(Plant *p) {
    if (p->fault == 1 && p->n == 3) return failed(p, "the spring is broken");
    if (p->fault == 3 && p->n == 3) raise(SIGSEGV);
    if (p->fault == 4 && p->n == 3) sleep(30);
    if (p->fault == 5 && p->n == 3) usleep(2500000);
    p->y = p->gain * p->u;
    p->b = p->y > 10.0;
    p->n += 1;
    return 0;
}

static double *real(Plant *p, uint32_t reference) {
    return reference == 1 ? &p->u : reference == 2 ? &p->y : reference == 3 ? &p->gain : NULL;
}

static int32_t *whole(Plant *p, uint32_t reference) {
    return reference == 4 ? &p->n : reference == 5 ? &p->fault : NULL;
}

#define ACCESS(name, type, field)                                                            \
    int API(Get##name)(Plant * p, const uint32_t r[], size_t n, type v[] COUNT) {            \
        for (size_t i = 0; i < n; i++) {                                                     \
            if (!field(p, r[i])) return failed(p, "no such variable");                       \
            v[i] = (type)*field(p, r[i]);                                                    \
        }                                                                                    \
        return 0;                                                                            \
    }                                                                                        \
    int API(Set##name)(Plant * p, const uint32_t r[], size_t n, const type v[] COUNT) {      \
        for (size_t i = 0; i < n; i++) {                                                     \
            if (!field(p, r[i])) return failed(p, "no such variable");                       \
            *field(p, r[i]) = v[i];                                                          \
        }                                                                                    \
        return 0;                                                                            \
    }
static bool *truth(Plant *p, uint32_t reference) { return reference == 6 ? &p->b : NULL; }
static int32_t *small(Plant *p, uint32_t reference) { return reference == 7 ? &p->small : NULL; }
ACCESS(Boolean, Truth, truth)

#ifdef FMI_2
ACCESS(Real, double, real)
ACCESS(Integer, int, whole)
void *fmi2Instantiate(const char *name, int kind, const char *guid, const char *place,
                      const Callbacks *callbacks, int visible, int logging) {
    if (strcmp(guid, "{1}")) return refused(callbacks->environment, callbacks->log, name, guid);
    return plant(callbacks->environment, callbacks->log, name);
}
int fmi2SetupExperiment(Plant *p, int a, double b, double c, int d, double e) { return 0; }
int fmi2EnterInitializationMode(Plant *p) { return 0; }
int fmi2DoStep(Plant *p, double t, double h, int none) {
    if (p->fault == 2) return 2;
    return step(p);
}
#else
ACCESS(Float64, double, real)
ACCESS(Int32, int32_t, whole)
ACCESS(UInt8, uint8_t, small)
void *fmi3InstantiateCoSimulation(const char *name, const char *token, const char *place,
                                  bool visible, bool logging, bool events, bool early,
                                  const uint32_t required[], size_t n, void *environment, Log log,
                                  void *update) {
    if (strcmp(token, "{1}")) return refused(environment, log, name, token);
    return plant(environment, log, name);
}
int fmi3EnterInitializationMode(Plant *p, bool a, double b, double c, bool d, double e) {
    return 0;
}
int fmi3DoStep(Plant *p, double t, double h, bool none, bool *event, bool *end, bool *early,
               double *last) {
    *event = *early = false;
    *end = p->fault == 2 && p->n == 3;
    *last = t + h;
    return step(p);
}
#endif
int API(ExitInitializationMode)(Plant *p) { return 0; }
int API(Terminate)(Plant *p) { return 0; }
int API(Reset)(Plant *p) { return 0; }
void API(FreeInstance)(Plant *p) { free(p); }

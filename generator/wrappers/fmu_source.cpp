// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/wrappers/fmu_source.h"

namespace sinew {

// The declarations are those of the standard (https://fmi-standard.org, FMI 3.0), written out here
// so that the unit's sources need no header from elsewhere.
const char* const fmu_source = R"C(/* SPDX-License-Identifier: BSD-2-Clause
 *
 * An FMI 3.0 co-simulation unit over the emitted C of one model (fmu_model.h says which). Between two
 * communication points inputs are held, and M(q) qdd + C qd + g = tau is integrated by steps of the
 * classical Runge-Kutta method no longer than the parameter integration_step.
 *
 * Made by: sinew generate (--fmu). Do not edit: change the model and generate again.
 */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "fmu_model.h"

#if defined(_WIN32)
#define FMI3_Export __declspec(dllexport)
#else
#define FMI3_Export __attribute__((visibility("default")))
#endif

typedef void *fmi3Instance;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef void (*fmi3LogMessageCallback)(void *environment, fmi3Status status, const char *category,
                                       const char *message);

enum { POSITION, VELOCITY, STATES };  /* parts of the state */

typedef struct {
    double value[VARIABLES];  /* by value reference; 0 is the time */
    double state[STATES][JOINTS];
} unit_state;

typedef struct {
    unit_state now;
    void *environment;
    fmi3LogMessageCallback log;
} unit;

static void complain(const unit *u, const char *message)
{
    if (u->log) u->log(u->environment, fmi3Error, "logStatusError", message);
}

/* Torque on the joints: the tendons', the one given, and damping. */
static void torque(const unit_state *s, const double q[JOINTS], const double qd[JOINTS],
                   double tau[JOINTS])
{
#if defined(TENDON_TORQUE) && TENDONS > 0
    TENDON_TORQUE(q, s->value + TENDON_FORCE, tau);
#else
    (void)q;
    memset(tau, 0, JOINTS * sizeof tau[0]);
#endif
    for (int i = 0; i < JOINTS; ++i)
        tau[i] += s->value[JOINT_TORQUE + i] - s->value[DAMPING + i] * qd[i];
}

static void derivative(const unit_state *s, double state[STATES][JOINTS],
                       double rate[STATES][JOINTS])
{
    double tau[JOINTS];
    torque(s, state[POSITION], state[VELOCITY], tau);
    memcpy(rate[POSITION], state[VELOCITY], JOINTS * sizeof(double));
    FORWARD_DYNAMICS(state[POSITION], state[VELOCITY], tau, rate[VELOCITY]);
}

static void moved(double to[STATES][JOINTS], double from[STATES][JOINTS],
                  double rate[STATES][JOINTS], double by)
{
    for (int part = 0; part < STATES; ++part)
        for (int i = 0; i < JOINTS; ++i) to[part][i] = from[part][i] + by * rate[part][i];
}

static void integrate(unit_state *s, double h)
{
    double k[4][STATES][JOINTS], at[STATES][JOINTS];
    derivative(s, s->state, k[0]);
    moved(at, s->state, k[0], h / 2);
    derivative(s, at, k[1]);
    moved(at, s->state, k[1], h / 2);
    derivative(s, at, k[2]);
    moved(at, s->state, k[2], h);
    derivative(s, at, k[3]);
    moved(s->state, s->state, k[0], h / 6);
    moved(s->state, s->state, k[1], h / 3);
    moved(s->state, s->state, k[2], h / 3);
    moved(s->state, s->state, k[3], h / 6);
}

static void set_outputs(unit_state *s)
{
    double rate[STATES][JOINTS];
    derivative(s, s->state, rate);
    memcpy(s->value + Q, s->state[POSITION], JOINTS * sizeof(double));
    memcpy(s->value + QD, s->state[VELOCITY], JOINTS * sizeof(double));
    memcpy(s->value + QDD, rate[VELOCITY], JOINTS * sizeof(double));
#if defined(TENDON_LENGTHS) && TENDONS > 0
    TENDON_LENGTHS(s->state[POSITION], s->value + TENDON_LENGTH);
#endif
#ifdef TIP_POSE
    double pose[16];
    TIP_POSE(s->state[POSITION], pose);
    for (int i = 0; i < 3; ++i) s->value[TIP + i] = pose[4 * i + 3];
#endif
}

static void begin(unit_state *s)
{
    memcpy(s->state[POSITION], s->value + Q_START, JOINTS * sizeof(double));
    memcpy(s->state[VELOCITY], s->value + QD_START, JOINTS * sizeof(double));
    set_outputs(s);
}

static void reset(unit_state *s)
{
    static const double start[VARIABLES] = START_VALUES;
    memcpy(s->value, start, sizeof start);
    begin(s);
}

FMI3_Export const char *fmi3GetVersion(void) { return "3.0"; }

FMI3_Export fmi3Status fmi3SetDebugLogging(fmi3Instance instance, bool on, size_t count,
                                           const char *const categories[])
{
    (void)instance, (void)on, (void)count, (void)categories;
    return fmi3OK;
}

FMI3_Export fmi3Instance fmi3InstantiateCoSimulation(
    const char *name, const char *token, const char *resources, bool visible, bool logging,
    bool event_mode, bool early_return, const fmi3ValueReference wanted[], size_t wanted_count,
    void *environment, fmi3LogMessageCallback log, void *intermediate_update)
{
    (void)name, (void)resources, (void)visible, (void)logging, (void)event_mode;
    (void)early_return, (void)wanted, (void)wanted_count, (void)intermediate_update;
    if (!token || strcmp(token, TOKEN) != 0) {
        if (log)
            log(environment, fmi3Error, "logStatusError",
                "the modelDescription.xml is that of another model");
        return 0;
    }
    unit *u = calloc(1, sizeof *u);
    if (!u) return 0;
    u->environment = environment;
    u->log = log;
    reset(&u->now);
    return u;
}

FMI3_Export fmi3Instance fmi3InstantiateModelExchange(
    const char *name, const char *token, const char *resources, bool visible, bool logging,
    void *environment, fmi3LogMessageCallback log)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging;
    (void)environment, (void)log;
    return 0;
}

FMI3_Export fmi3Instance fmi3InstantiateScheduledExecution(
    const char *name, const char *token, const char *resources, bool visible, bool logging,
    void *environment, fmi3LogMessageCallback log, void *clock_update, void *lock, void *unlock)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)environment;
    (void)log, (void)clock_update, (void)lock, (void)unlock;
    return 0;
}

FMI3_Export void fmi3FreeInstance(fmi3Instance instance) { free(instance); }

FMI3_Export fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, bool has_tolerance,
                                                   double tolerance, double start, bool has_stop,
                                                   double stop)
{
    unit *u = instance;
    (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
    u->now.value[0] = start;
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3ExitInitializationMode(fmi3Instance instance)
{
    begin(&((unit *)instance)->now);
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3Terminate(fmi3Instance instance) { return (void)instance, fmi3OK; }

FMI3_Export fmi3Status fmi3Reset(fmi3Instance instance)
{
    reset(&((unit *)instance)->now);
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference references[],
                                      size_t count, double values[], size_t value_count)
{
    unit *u = instance;
    if (count != value_count) return complain(u, "every variable has one value"), fmi3Error;
    for (size_t i = 0; i < count; ++i)
        if (references[i] >= VARIABLES) return complain(u, "unknown value reference"), fmi3Error;
    set_outputs(&u->now);
    for (size_t i = 0; i < count; ++i) values[i] = u->now.value[references[i]];
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference references[],
                                      size_t count, const double values[], size_t value_count)
{
    unit *u = instance;
    if (count != value_count) return complain(u, "every variable has one value"), fmi3Error;
    for (size_t i = 0; i < count; ++i)
        if (references[i] == 0 || references[i] >= FIRST_OUTPUT)
            return complain(u, "only inputs and parameters can be set"), fmi3Error;
    for (size_t i = 0; i < count; ++i) u->now.value[references[i]] = values[i];
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3DoStep(fmi3Instance instance, double time, double step,
                                  bool no_set_state_before, bool *event_needed, bool *terminate,
                                  bool *early, double *last_time)
{
    unit *u = instance;
    const double longest = u->now.value[STEP];
    (void)no_set_state_before;
    if (!(longest > 0) || !(step >= 0) || step / longest > 1e9)
        return complain(u, "the step, or the parameter integration_step, cannot be"), fmi3Error;
    const long count = step > 0 ? (long)(step / longest * (1 - 1e-12)) + 1 : 0;
    for (long i = 0; i < count; ++i) integrate(&u->now, step / (double)count);
    u->now.value[0] = time + step;
    set_outputs(&u->now);
    *event_needed = *terminate = *early = false;
    *last_time = time + step;
    for (int i = 0; i < JOINTS; ++i)
        if (!(u->now.state[VELOCITY][i] - u->now.state[VELOCITY][i] == 0))
            return complain(u, "the motion has left all numbers: take a shorter integration_step"),
                   fmi3Error;
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState *state)
{
    if (!*state) *state = malloc(sizeof(unit_state));
    if (!*state) return fmi3Error;
    memcpy(*state, &((unit *)instance)->now, sizeof(unit_state));
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state)
{
    memcpy(&((unit *)instance)->now, state, sizeof(unit_state));
    return fmi3OK;
}

FMI3_Export fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState *state)
{
    (void)instance;
    free(*state);
    *state = 0;
    return fmi3OK;
}

/* The rest of the interface is there, so that every importer finds it, and says that it cannot. */
#define REFUSED(name, parameters) \
    FMI3_Export fmi3Status name parameters { return fmi3Error; }
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#define REFUSED_TYPE(type, c_type)                                                                \
    REFUSED(fmi3Get##type, (fmi3Instance i, const fmi3ValueReference r[], size_t n, c_type v[],   \
                            size_t m))                                                            \
    REFUSED(fmi3Set##type, (fmi3Instance i, const fmi3ValueReference r[], size_t n,               \
                            const c_type v[], size_t m))
typedef const char *fmi3String;
REFUSED_TYPE(Float32, float)
REFUSED_TYPE(Int8, int8_t)
REFUSED_TYPE(UInt8, uint8_t)
REFUSED_TYPE(Int16, int16_t)
REFUSED_TYPE(UInt16, uint16_t)
REFUSED_TYPE(Int32, int32_t)
REFUSED_TYPE(UInt32, uint32_t)
REFUSED_TYPE(Int64, int64_t)
REFUSED_TYPE(UInt64, uint64_t)
REFUSED_TYPE(Boolean, bool)
REFUSED_TYPE(String, fmi3String)
REFUSED(fmi3GetBinary, (fmi3Instance i, const fmi3ValueReference r[], size_t n, size_t s[],
                        const uint8_t *v[], size_t m))
REFUSED(fmi3SetBinary, (fmi3Instance i, const fmi3ValueReference r[], size_t n, const size_t s[],
                        const uint8_t *const v[], size_t m))
REFUSED(fmi3GetClock, (fmi3Instance i, const fmi3ValueReference r[], size_t n, bool v[]))
REFUSED(fmi3SetClock, (fmi3Instance i, const fmi3ValueReference r[], size_t n, const bool v[]))
REFUSED(fmi3GetNumberOfVariableDependencies, (fmi3Instance i, fmi3ValueReference r, size_t *n))
REFUSED(fmi3GetVariableDependencies, (fmi3Instance i, fmi3ValueReference d, size_t a[],
                                      fmi3ValueReference b[], size_t c[], int k[], size_t n))
REFUSED(fmi3SerializedFMUStateSize, (fmi3Instance i, fmi3FMUState s, size_t *n))
REFUSED(fmi3SerializeFMUState, (fmi3Instance i, fmi3FMUState s, uint8_t b[], size_t n))
REFUSED(fmi3DeserializeFMUState, (fmi3Instance i, const uint8_t b[], size_t n, fmi3FMUState *s))
REFUSED(fmi3GetDirectionalDerivative, (fmi3Instance i, const fmi3ValueReference u[], size_t n,
                                       const fmi3ValueReference k[], size_t m, const double s[],
                                       size_t p, double t[], size_t q))
REFUSED(fmi3GetAdjointDerivative, (fmi3Instance i, const fmi3ValueReference u[], size_t n,
                                   const fmi3ValueReference k[], size_t m, const double s[],
                                   size_t p, double t[], size_t q))
REFUSED(fmi3EnterConfigurationMode, (fmi3Instance i))
REFUSED(fmi3ExitConfigurationMode, (fmi3Instance i))
REFUSED(fmi3EnterEventMode, (fmi3Instance i))
REFUSED(fmi3EnterStepMode, (fmi3Instance i))
REFUSED(fmi3EnterContinuousTimeMode, (fmi3Instance i))
REFUSED(fmi3EvaluateDiscreteStates, (fmi3Instance i))
REFUSED(fmi3UpdateDiscreteStates, (fmi3Instance i, bool *a, bool *b, bool *c, bool *d, bool *e,
                                   double *t))
REFUSED(fmi3GetIntervalDecimal, (fmi3Instance i, const fmi3ValueReference r[], size_t n, double v[],
                                 int q[]))
REFUSED(fmi3GetIntervalFraction, (fmi3Instance i, const fmi3ValueReference r[], size_t n,
                                  uint64_t a[], uint64_t b[], int q[]))
REFUSED(fmi3GetShiftDecimal, (fmi3Instance i, const fmi3ValueReference r[], size_t n, double v[]))
REFUSED(fmi3GetShiftFraction, (fmi3Instance i, const fmi3ValueReference r[], size_t n, uint64_t a[],
                               uint64_t b[]))
REFUSED(fmi3SetIntervalDecimal, (fmi3Instance i, const fmi3ValueReference r[], size_t n,
                                 const double v[]))
REFUSED(fmi3SetIntervalFraction, (fmi3Instance i, const fmi3ValueReference r[], size_t n,
                                  const uint64_t a[], const uint64_t b[]))
REFUSED(fmi3SetShiftDecimal, (fmi3Instance i, const fmi3ValueReference r[], size_t n,
                              const double v[]))
REFUSED(fmi3SetShiftFraction, (fmi3Instance i, const fmi3ValueReference r[], size_t n,
                               const uint64_t a[], const uint64_t b[]))
REFUSED(fmi3CompletedIntegratorStep, (fmi3Instance i, bool a, bool *b, bool *c))
REFUSED(fmi3SetTime, (fmi3Instance i, double t))
REFUSED(fmi3SetContinuousStates, (fmi3Instance i, const double x[], size_t n))
REFUSED(fmi3GetContinuousStates, (fmi3Instance i, double x[], size_t n))
REFUSED(fmi3GetContinuousStateDerivatives, (fmi3Instance i, double x[], size_t n))
REFUSED(fmi3GetEventIndicators, (fmi3Instance i, double x[], size_t n))
REFUSED(fmi3GetNominalsOfContinuousStates, (fmi3Instance i, double x[], size_t n))
REFUSED(fmi3GetNumberOfEventIndicators, (fmi3Instance i, size_t *n))
REFUSED(fmi3GetNumberOfContinuousStates, (fmi3Instance i, size_t *n))
REFUSED(fmi3GetOutputDerivatives, (fmi3Instance i, const fmi3ValueReference r[], size_t n,
                                   const int o[], double v[], size_t m))
REFUSED(fmi3ActivateModelPartition, (fmi3Instance i, fmi3ValueReference r, double t))
)C";

}  // namespace sinew

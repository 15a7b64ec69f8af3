/* SPDX-License-Identifier: MIT */
/* nctakt.schedule.real.processes: start of a run's processes; named semaphores. */
#define PY_SSIZE_T_CLEAN
#define _GNU_SOURCE
#include <Python.h>

#include "shared_area.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#ifndef __linux__
#error "a schedule runs for real on Linux only"
#endif

_Static_assert(sizeof(sem_t) <= 8 * sizeof(int64_t), "a semaphore needs more room in a task");

static PyObject *spawn(PyObject *module, PyObject *arguments)
{
    (void)module;
    Py_buffer buffer;
    if (!PyArg_ParseTuple(arguments, "w*", &buffer))
        return NULL;
    struct area *area = buffer.buf;
    pid_t parent = getpid(), pid = fork();
    if (pid == 0) {
        run_scheduler(area, parent);
        _exit(0);
    }
    int error = errno;
    PyBuffer_Release(&buffer);
    if (pid < 0) {
        errno = error;
        return PyErr_SetFromErrno(PyExc_OSError);
    }
    return PyLong_FromLong(pid);
}

static PyObject *create(PyObject *module, PyObject *arguments)
{
    (void)module;
    const char *name;
    if (!PyArg_ParseTuple(arguments, "s", &name))
        return NULL;
    sem_t *semaphore = sem_open(name, O_CREAT | O_EXCL, 0600, 0);
    if (semaphore == SEM_FAILED)
        return PyErr_SetFromErrnoWithFilename(PyExc_OSError, name);
    sem_close(semaphore);
    Py_RETURN_NONE;
}

static PyObject *remove_name(PyObject *module, PyObject *arguments)
{
    (void)module;
    const char *name;
    if (!PyArg_ParseTuple(arguments, "s", &name))
        return NULL;
    if (sem_unlink(name) != 0)
        return PyErr_SetFromErrnoWithFilename(PyExc_OSError, name);
    Py_RETURN_NONE;
}

/* Wait without the interpreter's lock until a time of CLOCK_MONOTONIC; return when it ended. */
static PyObject *wait_until(PyObject *module, PyObject *argument)
{
    (void)module;
    int64_t moment = PyLong_AsLongLong(argument), now;
    if (moment == -1 && PyErr_Occurred())
        return NULL;
    struct timespec time = {moment / 1000000000LL, moment % 1000000000LL};
    Py_BEGIN_ALLOW_THREADS
    while (moment > 0 && clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, NULL) == EINTR) {
    }
    now = clock_ns(CLOCK_MONOTONIC);
    Py_END_ALLOW_THREADS
    return PyLong_FromLongLong(now);
}

/* Set scheduling class and processor of the calling thread; return errno, or 0. */
static PyObject *place_thread(PyObject *module, PyObject *arguments)
{
    (void)module;
    int priority, cpu;
    if (!PyArg_ParseTuple(arguments, "ii", &priority, &cpu))
        return NULL;
    int error = cpu > 0 && cpu <= CPU_SETSIZE ? use_cpu(cpu) : 0;
    int refused = use_fifo(priority);
    return PyLong_FromLong(error ? error : refused);
}

static PyObject *open_name(PyObject *module, PyObject *arguments)
{
    (void)module;
    const char *name;
    if (!PyArg_ParseTuple(arguments, "s", &name))
        return NULL;
    sem_t *semaphore = sem_open(name, 0);
    if (semaphore == SEM_FAILED)
        return PyErr_SetFromErrnoWithFilename(PyExc_OSError, name);
    return PyCapsule_New(semaphore, "nctakt.semaphore", NULL);
}

/* Post an open semaphore; return how many earlier posts are still there. */
static PyObject *post(PyObject *module, PyObject *capsule)
{
    (void)module;
    sem_t *semaphore = PyCapsule_GetPointer(capsule, "nctakt.semaphore");
    int waiting = 0;
    if (semaphore == NULL)
        return NULL;
    if (sem_getvalue(semaphore, &waiting) != 0 || sem_post(semaphore) != 0)
        return PyErr_SetFromErrno(PyExc_OSError);
    return PyLong_FromLong(waiting);
}

static PyMethodDef methods[] = {
    {"wait_until", wait_until, METH_O, "Wait for a moment of the monotonic clock in ns."},
    {"place_thread", place_thread, METH_VARARGS, "Set class and processor of this thread."},
    {"open", open_name, METH_VARARGS, "Open a named semaphore; OSError."},
    {"post", post, METH_O, "Give an opened semaphore; its count before."},
    {"spawn", spawn, METH_VARARGS, "Start the scheduler over an area; its process ID."},
    {"create", create, METH_VARARGS, "Make a named semaphore that must not exist; OSError."},
    {"remove", remove_name, METH_VARARGS, "Remove a named semaphore; OSError."},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT,
    .m_name = "processes",
    .m_doc = "Starts the processes of a run; named semaphores.",
    .m_size = 0,
    .m_methods = methods,
};

PyMODINIT_FUNC PyInit_processes(void)
{
    PyObject *module = PyModule_Create(&definition);
    if (module == NULL)
        return NULL;
    PyModule_AddIntConstant(module, "AREA_SIZE", sizeof(struct area));
    PyModule_AddIntConstant(module, "TASK_SIZE", sizeof(struct task));
    PyModule_AddIntConstant(module, "ENTRY_SIZE", sizeof(struct entry));
    return module;
}

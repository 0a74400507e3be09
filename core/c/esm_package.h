/* Model packages and their motion for programs in C, and in any language that calls C.
 *
 *     EsmError error;
 *     EsmPackage* package = esmOpenPackage("liver.glb", &error);
 *     EsmSimulation* simulation = package ? esmMakeSimulation(package, NULL, &error) : NULL;
 *     if (!simulation || esmStep(simulation, 10, &error) < 10) fprintf(stderr, "%s\n", error.text);
 *
 * Metres, kilograms, seconds, newtons. Nothing is shared between objects: each may live on a thread of its
 * own, one thread at a time. What can fail takes an `error`, which may be NULL; on success its text is empty.
 * It refuses NULL for a package or a simulation. All else needs what was opened or made.
 * Arrays belong to the object that they are asked of. What the model's parts mean is said in
 * docs/model-package.md. */
#ifndef ESM_PACKAGE_H
#define ESM_PACKAGE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct EsmPackage EsmPackage;
typedef struct EsmSimulation EsmSimulation;

/* What went wrong, where and what to do: one line of UTF-8, cut where it is longer, or "". */
typedef struct EsmError {
    char text[1024];
} EsmError;

/* Point masses, numbered from 0. */
typedef struct EsmNodes {
    size_t count;
    const double* restPositions;   /* m, 3 * count: x, y, z of each */
    const double* masses;          /* kg, count */
    const double* springConstants; /* N/m, count: the tissue's at the node */
    const double* viscosities;     /* N·s/m, count: the same */
} EsmNodes;

typedef struct EsmSprings {
    size_t count;
    const uint32_t* nodes;         /* 2 * count: both ends of each */
    const double* restLengths;     /* m, count */
    const double* springConstants; /* N/m, count: the spring's own */
    const double* viscosities;     /* N·s/m, count: the same */
} EsmSprings;

/* Springs without length from a node to its own rest position. */
typedef struct EsmTethers {
    size_t count;
    const uint32_t* nodes;         /* count; a node may have several */
    const double* springConstants; /* N/m, count */
    const double* viscosities;     /* N·s/m, count */
} EsmTethers;

typedef struct EsmFixedNodes {
    size_t count;
    const uint32_t* nodes; /* count, ascending, each once */
} EsmFixedNodes;

/* Pairs of triangles that resist being bent about the edge that they share. */
typedef struct EsmHinges {
    size_t count;
    const uint32_t* nodes;     /* 4 * count: both ends of the edge, then the corner on either side */
    const double* stiffnesses; /* N·m for each radian, count */
    const double* viscosities; /* N·m·s for each radian, count */
} EsmHinges;

/* Springs that go on with another constant once they are longer than (1 + strain) times their rest length. */
typedef struct EsmStiffening {
    double strain; /* > 0; 0: springs are linear */
    double factor; /* of their own spring constant; 1 where they are linear */
} EsmStiffening;

/* The drawn surface, every vertex once. */
typedef struct EsmSurface {
    size_t vertexCount;
    const double* restPositions; /* m, 3 * vertexCount */
    const uint32_t* vertexNodes; /* vertexCount: the node that carries each, or most of it */
    size_t triangleCount;
    const uint32_t* triangles; /* 3 * triangleCount: vertices, counter-clockwise seen from outside */
} EsmSurface;

/* How nodes carry the vertices of the surface where these are not nodes themselves. */
typedef struct EsmBinding {
    size_t vertexCount;     /* that of the surface; 0: each vertex keeps its place at its node */
    const uint32_t* starts; /* vertexCount + 1: where each vertex begins below, and where the last ends */
    const uint32_t* nodes;
    const double* shares; /* sum 1 in each vertex */
    size_t triangleCount;
    const uint32_t* triangles; /* 3 * triangleCount: nodes */
    size_t lineCount;
    const uint32_t* lines; /* 2 * lineCount: nodes */
} EsmBinding;

/* What fills the body of a solid organ. */
typedef struct EsmLattice {
    const char* kind; /* "cubic", "body-centred", … as in docs/model-package.md; NULL: nothing fills it */
    size_t tetrahedronCount;
    const uint32_t* tetrahedra; /* 4 * tetrahedronCount: nodes, in positive order */
    size_t triangleCount;
    const uint32_t* triangles; /* 3 * triangleCount: nodes, the surface that an instrument touches */
} EsmLattice;

/* Closed parts of the simulated surface that fluid fills. */
typedef struct EsmFillings {
    size_t count;
    const uint32_t* parts;     /* count: among the connected parts, in the order of their first triangles */
    const double* stiffnesses; /* Pa, count */
} EsmFillings;

/* How the organ's maker measured it to be stepped best. */
typedef struct EsmStepping {
    const char* integrator; /* NULL: nothing was measured */
    double timeStep;        /* s */
    int isSinglePrecision;
    double error;                  /* relative to the motion itself */
    double wallPerSimulatedSecond; /* on the machine that measured */
} EsmStepping;

/* All that a package says of what moves. It may grow at its end; the structs within stay as they are. */
typedef struct EsmModel {
    const char* name;
    EsmNodes nodes;
    EsmSprings springs;
    EsmTethers tethers;
    EsmFixedNodes fixedNodes;
    EsmStiffening stiffening;
    EsmSurface surface;
    EsmBinding binding;
    EsmLattice lattice;
    EsmHinges hinges;
    EsmFillings fillings;
    EsmStepping stepping;
} EsmModel;

/* NULL where the file is missing, damaged, no model package, or of a newer version. */
EsmPackage* esmOpenPackage(const char* file, EsmError* error);
/* Simulations that were made of it live on. NULL is ignored. */
void esmFreePackage(EsmPackage* package);
/* Valid until the package is freed. */
const EsmModel* esmModelOf(const EsmPackage* package);

/* All zero, or NULL for the whole: what was recommended where that is stable, else chosen safely. */
typedef struct EsmSettings {
    const char* integrator; /* "auto", "euler", … as in docs/command-line.md; NULL: left open */
    double timeStep;        /* s; 0: left open */
    int isSinglePrecision;  /* explicit integrators compute with float */
    int dampsAxially;       /* springs damp along themselves alone; some integrators refuse it */
    size_t threads;         /* at most; 0: as many as the tissue's size is worth */
} EsmSettings;

/* A rigid shape that pushes the surface: all that lies within the radius of a segment along its own z. */
typedef struct EsmInstrument {
    double radius;         /* m, > 0 */
    double length;         /* m, of the segment; 0: a sphere */
    double place[3];       /* m, of the segment's middle */
    double orientation[4]; /* unit quaternion w, x, y, z from its axes to the model's; all 0: not turned */
} EsmInstrument;

/* At rest, without loads but the pressures from within that the package has. Takes as long as its matrices
 * take to factorise. NULL on failure. */
EsmSimulation* esmMakeSimulation(const EsmPackage* package, const EsmSettings* settings, EsmError* error);
/* NULL is ignored. */
void esmFreeSimulation(EsmSimulation* simulation);

const char* esmIntegratorOf(const EsmSimulation* simulation); /* what was chosen */
double esmTimeStepOf(const EsmSimulation* simulation);        /* s */
double esmTimeOf(const EsmSimulation* simulation);            /* s since the start */

/* Loads stay until they are set anew. Each returns 1, or 0 where a node does not exist or a number is none;
 * the loads are then as they were. */
int esmSetGravity(EsmSimulation* simulation, const double gravity[3], EsmError* error); /* m/s² */
/* In place of all forces before. `forces`: N, 3 * count; a node may be named several times. */
int esmSetForces(EsmSimulation* simulation, size_t count, const uint32_t* nodes, const double* forces,
                 EsmError* error);
/* In place of all led nodes before. `places`: m, 3 * count, where they are at the end of the next step, and
 * stay; the way there is part of that step. Fixed nodes stay where they are. */
int esmLeadNodes(EsmSimulation* simulation, size_t count, const uint32_t* nodes, const double* places,
                 EsmError* error);
/* Where all instruments are at the end of the next step, each the same one by its place in the list; a new
 * one appears where it is. */
int esmPlaceInstruments(EsmSimulation* simulation, size_t count, const EsmInstrument* instruments,
                        EsmError* error);

/* Takes up to `count` steps; how many were taken. Fewer where motion ran wild or a step could not be
 * computed: the state is then the last good one, and the error says why. */
size_t esmStep(EsmSimulation* simulation, size_t count, EsmError* error);
/* Back to rest at time 0; loads stay, instruments are away. */
void esmReset(EsmSimulation* simulation);

/* Valid until the simulation steps, is put to rest or is freed. */
const double* esmPositionsOf(const EsmSimulation* simulation);  /* m, 3 * nodes.count */
const double* esmVelocitiesOf(const EsmSimulation* simulation); /* m/s, 3 * nodes.count */
/* Writes where the nodes carry the surface's vertices: m, 3 * surface.vertexCount. 1, or 0 on failure. */
int esmDrawnVertices(const EsmSimulation* simulation, double* vertices, EsmError* error);
/* N·s, of the tissue on an instrument since the start: over time, the mean force. Zero without such an
 * instrument. */
void esmInstrumentImpulse(const EsmSimulation* simulation, size_t instrument, double impulse[3]);

#ifdef __cplusplus
}
#endif

#endif

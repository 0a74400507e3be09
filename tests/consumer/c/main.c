#include <esm_package.h>

#include <stdio.h>
#include <stdlib.h>

/* Pulls at a node for ten steps; 1 where the node and the surface went along. */
static int moves(EsmSimulation* simulation, const EsmModel* model, EsmError* error) {
    const uint32_t node = 85;
    const double force[3] = {0, 0, -1};
    double* const vertices = malloc(3 * model->surface.vertexCount * sizeof(double));
    const double before = esmPositionsOf(simulation)[3 * node + 2];
    const int moved = vertices && esmSetForces(simulation, 1, &node, force, error) &&
                      esmStep(simulation, 10, error) == 10 && esmDrawnVertices(simulation, vertices, error) &&
                      esmPositionsOf(simulation)[3 * node + 2] < before &&
                      vertices[3 * node + 2] == esmPositionsOf(simulation)[3 * node + 2];
    free(vertices);
    return moved;
}

/* Loads the package named first, moves it, and prints its number of nodes and springs and how it was stepped. */
int main(int argumentCount, char** arguments) {
    EsmError error;
    EsmPackage* const package = esmOpenPackage(argumentCount == 2 ? arguments[1] : NULL, &error);
    EsmSimulation* const simulation = package ? esmMakeSimulation(package, NULL, &error) : NULL;
    const int done = simulation && moves(simulation, esmModelOf(package), &error);
    if (done)
        printf("%lu nodes, %lu springs, %s\n", (unsigned long)esmModelOf(package)->nodes.count,
               (unsigned long)esmModelOf(package)->springs.count, esmIntegratorOf(simulation));
    else
        fprintf(stderr, "%s\n", error.text);
    esmFreeSimulation(simulation);
    esmFreePackage(package);
    return done ? 0 : 1;
}

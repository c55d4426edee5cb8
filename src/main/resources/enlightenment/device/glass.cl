// The solids of glass that a ray is inside of: transport.ray.MediumStack. Where they are nested too deeply the sample is left to the host.
#define MAX_SOLIDS 8

typedef struct {
    int ids[MAX_SOLIDS];
    int count;
} Solids;

// The solid that is the medium, or -1 in empty space.
int mediumOf(const Scene *s, const Solids *inside) {
    int best = NOTHING;
    for (int k = 0; k < inside->count; k++) {
        if (best < 0 || primitive(s, inside->ids[k])[RANK] < primitive(s, best)[RANK]) {
            best = inside->ids[k];
        }
    }
    return best;
}

// The numbers of a medium: its index of refraction, whether it absorbs light, and its coefficients of absorption.
#define ABSORBS 1
#define ABSORPTION 2

__global const double *numbersOfMedium(const Scene *s, int medium) {
    return s->d + primitive(s, medium)[MEDIUM];
}

double indexOf(const Scene *s, int medium) {
    return medium < 0 ? 1 : numbersOfMedium(s, medium)[0];
}

bool absorbsLight(const Scene *s, int medium) {
    return medium >= 0 && numbersOfMedium(s, medium)[ABSORBS] != 0;
}

// Enters a solid through its border, or leaves it.
void crossBorder(Scene *s, Solids *inside, int solid, int side) {
    int at = NOTHING;
    for (int k = 0; k < inside->count; k++) {
        if (inside->ids[k] == solid) {
            at = k;
        }
    }
    if (side == OUTSIDE && at < 0) {
        if (inside->count == MAX_SOLIDS) {
            s->state = LEFT_TO_HOST;
        } else {
            inside->ids[inside->count++] = solid;
        }
    } else if (side != OUTSIDE && at >= 0) {
        inside->ids[at] = inside->ids[--inside->count];
    }
}

// What may occlude a light from a vertex: world.light.OccluderSet.Judge, LightPyramid, and world.Tracer.prepareShadows. Where there are a few
// primitives the answer decides which estimate is taken, so it is the processor's to the last bit; with more of them a ray is traced.
#define OCCLUDER_SIZE 3
#define OCCLUDER_TRAITS 1
#define OCCLUDER_NUMBERS 2

// Traits of an occluder, then the sides of its plane that the light lies on.
#define OCCLUDER_IS_BALL 1
#define OCCLUDER_HAS_PLANE 2
#define LIGHT_ABOVE 4
#define LIGHT_BELOW 8

#define PLANE_ERROR GAMMA(16)
#define PYRAMID_ERROR GAMMA(64)
#define PYRAMID_NUMBERS 15
#define PYRAMID_BOX 12

#define SEES_ALL 0
#define SEES_NONE 1
#define SEES_MAYBE 2

// The last vertex of a path that scattered light other than into single directions.
typedef struct {
    Vec p;
    // The shading normal on the side that the path came from.
    Vec n;
    int id;
    int element;
    int side;
    // Whether rays that leave it cannot meet its primitive again.
    bool neverReturns;
    bool isMatte;
    bool tookAll;
    bool leavesSmall;
} Vertex;

typedef struct {
    double x;
    double y;
    double z;
    double slack;
    double slack2;
} Apex;

void setApex(Apex *a, __global const double *q, Vec p) {
    double dx = q[0] - p.x;
    double dy = q[1] - p.y;
    double dz = q[2] - p.z;
    a->x = along(q + 3, dx, dy, dz);
    a->y = along(q + 6, dx, dy, dz);
    a->z = along(q + 9, dx, dy, dz);
    double size = q[14] + fabs(p.x) + fabs(p.y) + fabs(p.z);
    a->slack = PYRAMID_ERROR * size;
    a->slack2 = a->slack * size;
}

double acrossPyramid(const Apex *a, __global const double *b, int i, int k, double edge) {
    return fabs(a->z * b[i] - edge * b[k]) + fabs(a->z * b[i + 3] - edge * b[k + 3]) + fabs(a->z * b[i + 6] - edge * b[k + 6]) + a->slack2;
}

bool pyramidMisses(const Apex *a, __global const double *q, int id) {
    __global const double *b = q + PYRAMID_NUMBERS + PYRAMID_BOX * id;
    double cx = b[0] + a->x;
    double cy = b[1] + a->y;
    double cz = b[2] + a->z;
    double depth = fabs(b[5]) + fabs(b[8]) + fabs(b[11]) + a->slack;
    double ahead = a->z > 0 ? cz : -cz;
    if (ahead < -depth || ahead - depth > fabs(a->z)) {
        return true;
    }
    double beyondX = a->x + q[12];
    double beyondY = a->y + q[13];
    double side = a->z > 0 ? 1 : -1;
    return side * (a->x * cz - a->z * cx) > acrossPyramid(a, b, 3, 5, a->x)
            || side * (a->z * cx - beyondX * cz) > acrossPyramid(a, b, 3, 5, beyondX)
            || side * (a->y * cz - a->z * cy) > acrossPyramid(a, b, 4, 5, a->y)
            || side * (a->z * cy - beyondY * cz) > acrossPyramid(a, b, 4, 5, beyondY);
}

// Whether no segment from the vertex to the light crosses the plane of a flat primitive.
bool staysBeside(__global const double *plane, Vec p, int traits) {
    double offset = plane[3];
    double height = plane[0] * p.x + plane[1] * p.y + plane[2] * p.z - offset;
    double error = PLANE_ERROR * (fabs(p.x) + fabs(p.y) + fabs(p.z) + fabs(offset));
    if (height > error) {
        return (traits & LIGHT_ABOVE) != 0;
    }
    return height >= -error || (traits & LIGHT_BELOW) != 0;
}

// What is known without a ray. Sets the occluders, as bits, that a ray must be tested against.
int visibilityOf(const Scene *s, const Vertex *at, const Seen *v, ulong *suspects) {
    int count = v->light[OCCLUDER_COUNT];
    *suspects = 0;
    if (count < 0) {
        return SEES_MAYBE;
    }
    int pyramid = v->light[PYRAMID];
    Apex apex;
    if (pyramid >= 0) {
        setApex(&apex, s->d + pyramid, at->p);
    }
    const Cone *cone = &v->view.cone;
    __global const int *o = s->i + v->light[OCCLUDERS];
    for (int k = 0; k < count; k++, o += OCCLUDER_SIZE) {
        int id = o[0];
        if (at->neverReturns && id == at->id || v->light[HIDES_NOTHING] != 0 && id == v->light[LIGHT_SURFACE]) {
            continue;
        }
        int traits = o[OCCLUDER_TRAITS];
        __global const double *q = s->d + o[OCCLUDER_NUMBERS];
        if ((traits & OCCLUDER_HAS_PLANE) != 0 && staysBeside(q + 4, at->p, traits)) {
            continue;
        }
        if (coneMisses(cone, q[0], q[1], q[2], q[3]) || pyramid >= 0 && pyramidMisses(&apex, s->d + pyramid, id)) {
            continue;
        }
        if ((traits & OCCLUDER_IS_BALL) != 0 && coneIsHiddenBy(cone, q[0], q[1], q[2], q[3])) {
            return SEES_NONE;
        }
        *suspects |= 1UL << k;
    }
    return *suspects == 0 ? SEES_ALL : SEES_MAYBE;
}

// Whether anything is between the vertex and the point of the light that was sampled.
bool isHidden(Scene *s, const Vertex *at, const Seen *v, ulong suspects) {
    Ray shadow;
    setRay(s, &shadow, at->p.x, at->p.y, at->p.z, v->view.d.x, v->view.d.y, v->view.d.z, 0);
    shadow.start = at->id;
    shadow.startElement = at->element;
    shadow.startSide = at->side;
    double tMax = v->view.length;
    s->shadowRays++;
    if (v->light[ENDS_ON_FACE] != 0) {
        shadow.end = v->light[LIGHT_SURFACE];
        shadow.endFace = v->light[LIGHT_FACE];
        shadow.tEnd = tMax;
        shadow.endTolerance = v->view.q[END_TOLERANCE];
    }
    if (v->light[OCCLUDER_COUNT] < 0) {
        Closest best;
        best.t = tMax;
        best.id = NOTHING;
        return search(s, &shadow, true, v->light[LIGHT_HIERARCHY], &best);
    }
    __global const int *o = s->i + v->light[OCCLUDERS];
    for (int k = 0; suspects != 0; k++, suspects >>= 1) {
        if ((suspects & 1) != 0 && blocks(s, &shadow, o[OCCLUDER_SIZE * k], tMax)) {
            return true;
        }
    }
    return false;
}

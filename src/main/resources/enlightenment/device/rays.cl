// Rays and hits (primitive.Ray, primitive.Hit, primitive.Watertight), and the scene's arrays: device.DeviceScene writes them.
#define OUTSIDE 1
#define INSIDE (-1)
#define NOTHING (-1)
#define MISS INFINITY

// What ends a sample on the device; the host then takes it from the start.
#define DONE 0
#define LEFT_TO_HOST 1

typedef struct {
    double ox;
    double oy;
    double oz;
    double dx;
    double dy;
    double dz;
    double dd;
    double tMin;
    // The primitive and its element that the ray starts on, and the side that it travels on.
    int start;
    int startElement;
    int startSide;
    // The face that the ray ends on, or no primitive's; where it ends, and how far off that may be: no matter where it is flat.
    int end;
    int endFace;
    double tEnd;
    double endTolerance;
    // The element that the last test found.
    int element;
    int kx;
    int ky;
    int kz;
    bool sheared;
    double shearX;
    double shearY;
} Ray;

typedef struct {
    double t;
    Vec p;
    Vec n;
    int side;
    int face;
    int id;
    int element;
    double weightB;
    double weightC;
} Hit;

typedef struct {
    __global const double *d;
    __global const int *i;
    __global const float *f;
    // Set where a sample must be left to the host.
    int state;
    // Of one sample: hits and rays by kind, as world.parts.RayCounters counts them.
    int shadowRays;
    int mirrorRays;
    int refractedRays;
    int lightSamples;
    int textureLookups;
} Scene;

// A record of a primitive among the integers: what it is, where its numbers are, where the materials of its faces are, whether it encloses
// a volume, where the boxes are in which its faces touch others and how many, its rank as a medium, where the numbers of that
// are, whether it is flat, convex, or has flat faces only, and where the lights are that its faces are (or -1).
#define PRIMITIVE_SIZE 10
#define KIND 0
#define NUMBERS 1
#define FACES 2
#define IS_SOLID 3
#define CONTACTS 4
#define CONTACT_COUNT 5
#define RANK 6
#define MEDIUM 7
#define TRAITS 8
#define FACE_LIGHTS 9

#define IS_FLAT 1
#define IS_CONVEX 2
#define HAS_FLAT_FACES 4

__global const int *primitive(const Scene *s, int id) {
    return s->i + s->i[PRIMITIVES] + PRIMITIVE_SIZE * id;
}

__global const double *numbersOf(const Scene *s, int id) {
    return s->d + primitive(s, id)[NUMBERS];
}

void setRay(Scene *s, Ray *r, double x, double y, double z, double dx, double dy, double dz, double from) {
    r->ox = x;
    r->oy = y;
    r->oz = z;
    r->dx = dx;
    r->dy = dy;
    r->dz = dz;
    r->dd = dx * dx + dy * dy + dz * dz;
    r->tMin = from;
    r->start = NOTHING;
    r->startElement = 0;
    r->startSide = 0;
    r->end = NOTHING;
    r->sheared = false;
    double oo = x * x + y * y + z * z;
    // An extreme ray.
    if (!(r->dd <= 0x1p240 && r->dd >= 0x1p-240 && oo <= 0x1p240)) {
        s->state = LEFT_TO_HOST;
    }
}

void startOn(Ray *r, const Hit *hit, int side) {
    r->start = hit->id;
    r->startElement = hit->element;
    r->startSide = side;
}

double originOf(const Ray *r, int axis) {
    return axis == 0 ? r->ox : axis == 1 ? r->oy : r->oz;
}

double directionOf(const Ray *r, int axis) {
    return axis == 0 ? r->dx : axis == 1 ? r->dy : r->dz;
}

void shear(Ray *r) {
    if (r->sheared) {
        return;
    }
    double ax = fabs(r->dx);
    double ay = fabs(r->dy);
    double az = fabs(r->dz);
    r->kz = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
    r->kx = r->kz == 2 ? 0 : r->kz + 1;
    r->ky = r->kx == 2 ? 0 : r->kx + 1;
    r->shearX = directionOf(r, r->kx) / directionOf(r, r->kz);
    r->shearY = directionOf(r, r->ky) / directionOf(r, r->kz);
    r->sheared = true;
}

double shearedX(const Ray *r, Vec v) {
    return fma(-r->shearX, component(v, r->kz) - originOf(r, r->kz), component(v, r->kx) - originOf(r, r->kx));
}

double shearedY(const Ray *r, Vec v) {
    return fma(-r->shearY, component(v, r->kz) - originOf(r, r->kz), component(v, r->ky) - originOf(r, r->ky));
}

// numeric.EdgeFunctions
#define EDGE_ERROR GAMMA(64)

bool covers(double e0, double e1, double e2) {
    bool anyNegative = e0 < 0 || e1 < 0 || e2 < 0;
    bool anyPositive = e0 > 0 || e1 > 0 || e2 > 0;
    return anyNegative != anyPositive;
}

double parameterOf(const Ray *r, Vec v) {
    return (component(v, r->kz) - originOf(r, r->kz)) / directionOf(r, r->kz);
}

double largestDifference(const Ray *r, Vec v) {
    return larger(fabs(v.x - r->ox), larger(fabs(v.y - r->oy), fabs(v.z - r->oz)));
}

double settled(const Ray *r, double t, Vec a, Vec b, Vec c, double e0, double e1, double e2) {
    double ta = parameterOf(r, a);
    double tb = parameterOf(r, b);
    double tc = parameterOf(r, c);
    double lo = ta < tb ? ta : tb;
    lo = tc < lo ? tc : lo;
    double hi = ta > tb ? ta : tb;
    hi = tc > hi ? tc : hi;
    double m = larger(largestDifference(r, a), larger(largestDifference(r, b), largestDifference(r, c)));
    double edge = smaller(fabs(e0), smaller(fabs(e1), fabs(e2)));
    bool central = edge > EDGE_ERROR * m * m;
    if (central && (t >= lo && t <= hi || t < r->tMin && lo < r->tMin)) {
        return t >= r->tMin ? t : MISS;
    }
    double between = (e1 * ta + e2 * tb + e0 * tc) / (e0 + e1 + e2);
    between = between < lo ? lo : between > hi ? hi : between;
    bool agree = fabs(t - between) * fabs(directionOf(r, r->kz)) <= EDGE_ERROR * m;
    double chosen = agree ? t : between;
    return chosen >= r->tMin ? chosen : MISS;
}

void setNormal(Hit *hit, double x, double y, double z) {
    double s = 1 / sqrt(x * x + y * y + z * z);
    hit->n = vec(x * s, y * s, z * s);
}

double clamp01(double v) {
    return v > 0 ? (v < 1 ? v : 1) : 0;
}

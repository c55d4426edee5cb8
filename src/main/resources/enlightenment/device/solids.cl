// Boxes, cubes, cylinders and cones: primitive.Slabs, BoxPrimitive, CubePrimitive, LateralInterval, AxialPrimitive, AxialSurface,
// CylinderPrimitive and ConePrimitive.
double slabEntry(double o, double d, double lo, double hi) {
    if (d > 0) {
        return (lo - o) / d;
    }
    if (d < 0) {
        return (hi - o) / d;
    }
    return o < lo || o > hi ? INFINITY : -INFINITY;
}

double slabExit(double o, double d, double lo, double hi) {
    if (d > 0) {
        return (hi - o) / d;
    }
    if (d < 0) {
        return (lo - o) / d;
    }
    return o < lo || o > hi ? -INFINITY : INFINITY;
}

double clampTo(double v, double lo, double hi) {
    return v < lo ? lo : v > hi ? hi : v;
}

int lastOf(Vec v) {
    return v.x >= v.y ? (v.x >= v.z ? 0 : 2) : (v.y >= v.z ? 1 : 2);
}

int firstOf(Vec v) {
    return v.x <= v.y ? (v.x <= v.z ? 0 : 2) : (v.y <= v.z ? 1 : 2);
}

double largestOf(Vec v) {
    double m = v.x >= v.y ? v.x : v.y;
    return m >= v.z ? m : v.z;
}

double smallestOf(Vec v) {
    double m = v.x <= v.y ? v.x : v.y;
    return m <= v.z ? m : v.z;
}

// Of a ray in the coordinates of a box: where it enters and leaves the slabs of its three axes.
Vec entriesOf(Vec o, Vec d, Vec lo, Vec hi) {
    return vec(slabEntry(o.x, d.x, lo.x, hi.x), slabEntry(o.y, d.y, lo.y, hi.y), slabEntry(o.z, d.z, lo.z, hi.z));
}

Vec exitsOf(Vec o, Vec d, Vec lo, Vec hi) {
    return vec(slabExit(o.x, d.x, lo.x, hi.x), slabExit(o.y, d.y, lo.y, hi.y), slabExit(o.z, d.z, lo.z, hi.z));
}

#define INTERVAL_ERROR (2 * GAMMA(3))

// Box: lower and upper corner.
double nearestBox(__global const double *q, const Ray *r, bool own, double tMax) {
    if (own && r->startSide == OUTSIDE) {
        return MISS;
    }
    Vec o = vec(r->ox, r->oy, r->oz);
    Vec d = vec(r->dx, r->dy, r->dz);
    double far = smallestOf(exitsOf(o, d, vecAt(q), vecAt(q + 3)));
    if (own) {
        double t = far >= r->tMin ? far : r->tMin;
        return t <= tMax ? t : MISS;
    }
    double near = largestOf(entriesOf(o, d, vecAt(q), vecAt(q + 3)));
    if (!(near <= far + fabs(far) * INTERVAL_ERROR)) {
        return MISS;
    }
    double t = near >= r->tMin ? near : far;
    return t >= r->tMin && t <= tMax ? t : MISS;
}

void completeBox(__global const double *q, const Ray *r, bool own, double t, Hit *hit) {
    Vec o = vec(r->ox, r->oy, r->oz);
    Vec d = vec(r->dx, r->dy, r->dz);
    Vec lo = vecAt(q);
    Vec hi = vecAt(q + 3);
    Vec entries = entriesOf(o, d, lo, hi);
    bool entering = !own && largestOf(entries) >= r->tMin;
    int axis = entering ? lastOf(entries) : firstOf(exitsOf(o, d, lo, hi));
    bool upper = entering ? directionOf(r, axis) < 0 : directionOf(r, axis) > 0;
    double sign = upper ? 1 : -1;
    hit->face = 2 * axis + (upper ? 1 : 0);
    hit->side = entering ? OUTSIDE : INSIDE;
    hit->n = vec(axis == 0 ? sign : 0, axis == 1 ? sign : 0, axis == 2 ? sign : 0);
    hit->p = vec(axis == 0 ? (upper ? hi.x : lo.x) : clampTo(fma(t, d.x, o.x), lo.x, hi.x),
            axis == 1 ? (upper ? hi.y : lo.y) : clampTo(fma(t, d.y, o.y), lo.y, hi.y),
            axis == 2 ? (upper ? hi.z : lo.z) : clampTo(fma(t, d.z, o.z), lo.z, hi.z));
}

double fractionOf(double v, double lo, double hi) {
    return hi > lo ? (v - lo) / (hi - lo) : 0;
}

void placeOnFace(int face, Vec at, double *uv) {
    double u = face == 0 ? 1 - at.z : face == 1 ? at.z : face == 5 ? 1 - at.x : at.x;
    double v = face == 2 ? at.z : face == 3 ? 1 - at.z : 1 - at.y;
    uv[0] = clamp01(u);
    uv[1] = clamp01(v);
}

// Cube: centre, half of the edge, its axes, whether it is a box, and that.
#define SLAB_ERROR GAMMA(8)
#define CUBE_IS_BOX 13
#define CUBE_BOX 14

Vec cubeOrigin(__global const double *q, const Ray *r) {
    double x = r->ox - q[0];
    double y = r->oy - q[1];
    double z = r->oz - q[2];
    return vec(fusedDot(q[4], q[5], q[6], x, y, z), fusedDot(q[7], q[8], q[9], x, y, z), fusedDot(q[10], q[11], q[12], x, y, z));
}

Vec cubeDirection(__global const double *q, const Ray *r) {
    return vec(accurateDot(q[4], q[5], q[6], r->dx, r->dy, r->dz), accurateDot(q[7], q[8], q[9], r->dx, r->dy, r->dz),
            accurateDot(q[10], q[11], q[12], r->dx, r->dy, r->dz));
}

double widenedHalf(__global const double *q, const Ray *r) {
    double distance = fabs(r->ox - q[0]) + fabs(r->oy - q[1]) + fabs(r->oz - q[2]);
    return q[3] + SLAB_ERROR * (distance + q[3]);
}

double nearestCube(__global const double *q, const Ray *r, bool own, double tMax) {
    if (q[CUBE_IS_BOX] != 0) {
        return nearestBox(q + CUBE_BOX, r, own, tMax);
    }
    if (own && r->startSide == OUTSIDE) {
        return MISS;
    }
    Vec o = cubeOrigin(q, r);
    Vec d = cubeDirection(q, r);
    double h = q[3];
    double far = smallestOf(exitsOf(o, d, vec(-h, -h, -h), vec(h, h, h)));
    if (own) {
        double t = far >= r->tMin ? far : r->tMin;
        return t <= tMax ? t : MISS;
    }
    double near = largestOf(entriesOf(o, d, vec(-h, -h, -h), vec(h, h, h)));
    if (!(near <= far)) {
        h = widenedHalf(q, r);
        near = largestOf(entriesOf(o, d, vec(-h, -h, -h), vec(h, h, h)));
        far = smallestOf(exitsOf(o, d, vec(-h, -h, -h), vec(h, h, h)));
        if (!(near <= far)) {
            return MISS;
        }
    }
    double t = near >= r->tMin ? near : far;
    return t >= r->tMin && t <= tMax ? t : MISS;
}

void completeCube(__global const double *q, const Ray *r, bool own, double t, Hit *hit) {
    if (q[CUBE_IS_BOX] != 0) {
        completeBox(q + CUBE_BOX, r, own, t, hit);
        double x = q[4] * hit->n.x + q[5] * hit->n.y + q[6] * hit->n.z;
        double y = q[7] * hit->n.x + q[8] * hit->n.y + q[9] * hit->n.z;
        double z = q[10] * hit->n.x + q[11] * hit->n.y + q[12] * hit->n.z;
        hit->face = x != 0 ? (x > 0 ? 1 : 0) : y != 0 ? (y > 0 ? 3 : 2) : (z > 0 ? 5 : 4);
        return;
    }
    Vec o = cubeOrigin(q, r);
    Vec d = cubeDirection(q, r);
    double halfOf = q[3];
    double h = halfOf;
    if (!own
            && !(largestOf(entriesOf(o, d, vec(-h, -h, -h), vec(h, h, h)))
                    <= smallestOf(exitsOf(o, d, vec(-h, -h, -h), vec(h, h, h))))) {
        h = widenedHalf(q, r);
    }
    Vec entries = entriesOf(o, d, vec(-h, -h, -h), vec(h, h, h));
    bool entering = !own && largestOf(entries) >= r->tMin;
    int k = entering ? lastOf(entries) : firstOf(exitsOf(o, d, vec(-h, -h, -h), vec(h, h, h)));
    Vec axis = vecAt(q + 4 + 3 * k);
    bool upper = entering ? component(d, k) < 0 : component(d, k) > 0;
    double sign = upper ? 1 : -1;
    hit->face = 2 * k + (upper ? 1 : 0);
    hit->side = entering ? OUTSIDE : INSIDE;
    setNormal(hit, sign * axis.x, sign * axis.y, sign * axis.z);
    double x = k == 0 ? sign * halfOf : clampTo(fma(t, d.x, o.x), -halfOf, halfOf);
    double y = k == 1 ? sign * halfOf : clampTo(fma(t, d.y, o.y), -halfOf, halfOf);
    double z = k == 2 ? sign * halfOf : clampTo(fma(t, d.z, o.z), -halfOf, halfOf);
    hit->p = vec(q[0] + fusedDot(q[4], q[7], q[10], x, y, z), q[1] + fusedDot(q[5], q[8], q[11], x, y, z),
            q[2] + fusedDot(q[6], q[9], q[12], x, y, z));
}

double cubeFraction(__global const double *q, const Hit *hit, int k) {
    __global const double *axis = q + 4 + 3 * k;
    if (q[CUBE_IS_BOX] == 0) {
        double along = fusedDot(axis[0], axis[1], axis[2], hit->p.x - q[0], hit->p.y - q[1], hit->p.z - q[2]);
        return along / (2 * q[3]) + 0.5;
    }
    __global const double *b = q + CUBE_BOX;
    double world = axis[0] != 0 ? fractionOf(hit->p.x, b[0], b[3])
            : axis[1] != 0      ? fractionOf(hit->p.y, b[1], b[4])
                                : fractionOf(hit->p.z, b[2], b[5]);
    return axis[0] + axis[1] + axis[2] > 0 ? world : 1 - world;
}

// Whether anything may be in the way of any shadow ray from a point to a light: no, only where that is certain. What the rays themselves
// would find is the same, so nothing here has to be rounded as in Java.
typedef struct {
    // Around the light's ball.
    Cone cone;
    // A box around apex and ball.
    Vec low;
    Vec high;
    // The primitive that the rays start on, and their side of it.
    int start;
    int side;
} Shaft;

// Whether the apex is outside of the ball: else there is no shaft.
bool setShaft(Shaft *f, Vec at, __global const double *ball, int start, int side) {
    setCone(&f->cone, ball[0], ball[1], ball[2], ball[3], at);
    if (f->cone.inside) {
        return false;
    }
    double d = f->cone.distance;
    double r = ball[3];
    f->start = start;
    f->side = side;
    double slack = CONE_ERROR * (fabs(at.x) + fabs(at.y) + fabs(at.z) + d + r);
    f->low = vec(fmin(at.x, ball[0] - r) - slack, fmin(at.y, ball[1] - r) - slack, fmin(at.z, ball[2] - r) - slack);
    f->high = vec(fmax(at.x, ball[0] + r) + slack, fmax(at.y, ball[1] + r) + slack, fmax(at.z, ball[2] + r) + slack);
    return true;
}

bool shaftMissesBox(const Shaft *f, double cx, double cy, double cz, double hx, double hy, double hz) {
    if (cx + hx < f->low.x || cx - hx > f->high.x || cy + hy < f->low.y || cy - hy > f->high.y || cz + hz < f->low.z || cz - hz > f->high.z) {
        return true;
    }
    return coneMisses(&f->cone, cx, cy, cz, sqrt(hx * hx + hy * hy + hz * hz));
}

// Whether all of the shaft is on one side of a plane through a with the normal n.
bool isOnOneSide(const Shaft *f, __global const double *a, __global const double *n) {
    double x = f->cone.at.x - a[0];
    double y = f->cone.at.y - a[1];
    double z = f->cone.at.z - a[2];
    double here = n[0] * x + n[1] * y + n[2] * z;
    double there = here + f->cone.distance * (n[0] * f->cone.w.x + n[1] * f->cone.w.y + n[2] * f->cone.w.z);
    double size = fabs(n[0]) + fabs(n[1]) + fabs(n[2]);
    Vec at = f->cone.at;
    double largest = fabs(a[0]) + fabs(a[1]) + fabs(a[2]) + fabs(at.x) + fabs(at.y) + fabs(at.z) + f->cone.distance + f->cone.radius;
    double slack = CONE_ERROR * size * largest;
    double reach = f->cone.radius * sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) + slack;
    return here > slack && there - reach > 0 || here < -slack && there + reach < 0;
}

bool mayBlock(const Scene *s, const Shaft *f, int item) {
    if (item == JOINED) {
        return true;
    }
    __global const double *q = numbersOf(s, item);
    int kind = primitive(s, item)[KIND];
    bool isFlat = kind == RECTANGLE || kind == TRIANGLE || kind == DISK;
    if (item == f->start && (isFlat || f->side == OUTSIDE && kind != MESH)) {
        // A ray that leaves it never comes back.
        return false;
    }
    switch (kind) {
        case SPHERE:
            return !coneMisses(&f->cone, q[0], q[1], q[2], q[3]);
        case RECTANGLE:
        case TRIANGLE:
        case DISK:
            return !isOnOneSide(f, q, q + 3);
        case BOX:
            return !shaftMissesBox(f, (q[0] + q[3]) / 2, (q[1] + q[4]) / 2, (q[2] + q[5]) / 2, (q[3] - q[0]) / 2 * (1 + CONE_ERROR),
                    (q[4] - q[1]) / 2 * (1 + CONE_ERROR), (q[5] - q[2]) / 2 * (1 + CONE_ERROR));
        default:
            return true;
    }
}

bool mayBeBlocked(const Scene *s, const Shaft *f, int hierarchy) {
    __global const float *boxes = s->f + s->i[BOXES + hierarchy];
    __global const int *child = s->i + s->i[CHILDREN + hierarchy];
    __global const int *order = s->i + s->i[ORDER + hierarchy];
    int stack[MAX_DEPTH];
    int depth = 1;
    stack[0] = 0;
    while (depth > 0) {
        int node = stack[--depth];
        for (int side = 0; side < 2; side++) {
            __global const float *b = boxes + NODE * node + side;
            if (shaftMissesBox(f, b[0], b[2], b[4], b[6], b[8], b[10])) {
                continue;
            }
            int link = child[2 * node + side];
            if (link >= 0) {
                stack[depth++] = link;
                continue;
            }
            int first = (int) ((uint) ~link >> 3);
            int end = first + (~link & 7);
            for (int k = first; k < end; k++) {
                if (mayBlock(s, f, order[k])) {
                    return true;
                }
            }
        }
    }
    return false;
}

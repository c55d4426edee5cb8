// What a ray meets: primitive.Primitive, accel.Closest, and a hierarchy searched as accel.FloatBvh is. Boxes only cull.
double nearestOf(const Scene *s, int id, Ray *r, double tMax) {
    __global const double *q = numbersOf(s, id);
    bool own = r->start == id;
    switch (primitive(s, id)[KIND]) {
        case SPHERE:
            return nearestSphere(q, r, own, tMax);
        case RECTANGLE:
            return nearestRectangle(q, r, own, tMax);
        case TRIANGLE:
            return nearestTriangle(q, r, own, tMax);
        case DISK:
            return nearestDisk(q, r, own, tMax);
        case BOX:
            return nearestBox(q, r, own, tMax);
        case CUBE:
            return nearestCube(q, r, own, tMax);
        case AXIAL: {
            Hit scratch;
            return crossingAxial(q, r, own, tMax, &scratch);
        }
        default:
            return MISS;
    }
}

void completeOf(const Scene *s, int id, const Ray *r, double t, Hit *hit) {
    __global const double *q = numbersOf(s, id);
    bool own = r->start == id;
    hit->t = t;
    hit->id = id;
    hit->element = 0;
    switch (primitive(s, id)[KIND]) {
        case SPHERE:
            completeSphere(q, r, own, hit);
            break;
        case RECTANGLE:
        case TRIANGLE:
            completePlane(q, r, t, hit);
            break;
        case DISK:
            completeDisk(q, r, hit);
            break;
        case BOX:
            completeBox(q, r, own, t, hit);
            break;
        case CUBE:
            completeCube(q, r, own, t, hit);
            break;
        case AXIAL:
            completeAxial(q, r, own, hit);
            break;
    }
}

// The texture coordinates of a hit: u to the right, v downwards.
void placeOnTexture(const Scene *s, const Hit *hit, double *uv) {
    __global const double *q = numbersOf(s, hit->id);
    int kind = primitive(s, hit->id)[KIND];
    if (kind == SPHERE) {
        double east = hit->n.z * q[4] - hit->n.x * q[5];
        double ahead = hit->n.x * q[4] + hit->n.z * q[5];
        double turn = angleOf(east, ahead) / (2 * PI);
        uv[0] = turn < 0 ? turn + 1 : turn;
        uv[1] = angleOf(sqrt(hit->n.x * hit->n.x + hit->n.z * hit->n.z), hit->n.y) / PI;
    } else if (kind == RECTANGLE) {
        placeOnPlane(q, hit, uv);
    } else if (kind == TRIANGLE) {
        placeOnPlane(q, hit, uv);
        __global const double *corners = q + PLANE_SIZE + 9;
        if (corners[0] != 0) {
            double a = 1 - uv[1];
            double b = uv[0];
            uv[0] = (1 - a - b) * corners[1] + a * corners[3] + b * corners[5];
            uv[1] = 1 - ((1 - a - b) * corners[2] + a * corners[4] + b * corners[6]);
        }
    } else if (kind == DISK) {
        placeOnDisk(vec(hit->p.x - q[0], hit->p.y - q[1], hit->p.z - q[2]), vecAt(q + 11), vecAt(q + 14), q[9], uv);
    } else if (kind == BOX) {
        placeOnFace(hit->face,
                vec(fractionOf(hit->p.x, q[0], q[3]), fractionOf(hit->p.y, q[1], q[4]), fractionOf(hit->p.z, q[2], q[5])), uv);
    } else if (kind == CUBE) {
        placeOnFace(hit->face, vec(cubeFraction(q, hit, 0), cubeFraction(q, hit, 1), cubeFraction(q, hit, 2)), uv);
    } else {
        placeOnAxial(q, hit, uv);
    }
}

// Whether u is periodic: 0 and 1 are the same place.
bool repeats(const Scene *s, int id) {
    int kind = primitive(s, id)[KIND];
    return kind == SPHERE || kind == TRIANGLE && numbersOf(s, id)[PLANE_SIZE + 9] != 0;
}

// bvh.FloatSlabs
typedef struct {
    float invX;
    float invY;
    float invZ;
    float offsetX;
    float offsetY;
    float offsetZ;
    float tMin;
} Slabs;

float roundedDown(double v) {
    return convert_float_rtn(v);
}

float roundedUp(double v) {
    return convert_float_rtp(v);
}

float inverseOf(double d) {
    return (float) larger(-0x1p60, smaller(0x1p60, 1 / d));
}

bool setSlabs(Slabs *b, const Ray *r, double reach) {
    double o = larger(fabs(r->ox), larger(fabs(r->oy), fabs(r->oz)));
    if (!(r->dd >= 0x1p-40 && r->dd <= 0x1p40 && o <= 2 * reach && r->tMin >= 0)) {
        return false;
    }
    b->invX = inverseOf(r->dx);
    b->invY = inverseOf(r->dy);
    b->invZ = inverseOf(r->dz);
    b->offsetX = (float) (-r->ox * b->invX);
    b->offsetY = (float) (-r->oy * b->invY);
    b->offsetZ = (float) (-r->oz * b->invZ);
    b->tMin = fmax(0.0f, roundedDown(r->tMin));
    return true;
}

// Where the ray enters a child's box; infinite if it misses that, or enters it beyond the limit.
float entryOf(const Slabs *s, __global const float *b, float limit) {
    float mx = fma(b[0], s->invX, s->offsetX);
    float my = fma(b[2], s->invY, s->offsetY);
    float mz = fma(b[4], s->invZ, s->offsetZ);
    float sx = fabs(s->invX);
    float sy = fabs(s->invY);
    float sz = fabs(s->invZ);
    float near = fmax(fmax(fma(-b[6], sx, mx), fma(-b[8], sy, my)), fmax(fma(-b[10], sz, mz), s->tMin));
    float far = fmin(fmin(fma(b[6], sx, mx), fma(b[8], sy, my)), fmin(fma(b[10], sz, mz), limit));
    return near <= far ? near : (float) INFINITY;
}

// accel.Closest
typedef struct {
    double t;
    int id;
    int element;
} Closest;

bool leavesAt(const Scene *s, const Ray *r, int id, double t) {
    Hit scratch;
    completeOf(s, id, r, t, &scratch);
    return scratch.side == INSIDE;
}

void offer(const Scene *s, Ray *r, int candidate, Closest *best) {
    double t = nearestOf(s, candidate, r, best->t);
    if (t == best->t && best->id != NOTHING) {
        bool leaves = leavesAt(s, r, candidate, t);
        bool known = leavesAt(s, r, best->id, t);
        if (leaves == known ? candidate < best->id : leaves) {
            best->id = candidate;
        }
    } else if (t <= best->t) {
        best->t = t;
        best->id = candidate;
    }
}

#define MAX_DEPTH 64
#define NODE 12
#define EMPTY_LEAF (~0)

// The closest primitive that a ray meets; or, where any will do, whether it meets one that is no farther than the limit.
bool search(Scene *s, Ray *r, bool any, Closest *best) {
    int stack[MAX_DEPTH];
    float entries[MAX_DEPTH];
    Slabs slabs;
    if (!setSlabs(&slabs, r, s->d[REACH])) {
        s->state = LEFT_TO_HOST;
        return false;
    }
    __global const int *child = s->i + s->i[CHILDREN];
    __global const int *order = s->i + s->i[ORDER];
    float limit = roundedUp(best->t);
    int depth = 1;
    stack[0] = 0;
    entries[0] = 0;
    while (depth > 0) {
        if (entries[--depth] > limit) {
            continue;
        }
        int node = stack[depth];
        while (node >= 0) {
            float l = entryOf(&slabs, s->f + NODE * node, limit);
            float right = entryOf(&slabs, s->f + NODE * node + 1, limit);
            int nearer = l <= right ? 0 : 1;
            int link = 2 * node;
            node = child[link + nearer];
            if (fmax(l, right) < (float) INFINITY) {
                entries[depth] = fmax(l, right);
                stack[depth++] = child[link + 1 - nearer];
            } else if (fmin(l, right) == (float) INFINITY) {
                node = EMPTY_LEAF;
            }
        }
        int first = (int) ((uint) ~node >> 3);
        int end = first + (~node & 7);
        for (int k = first; k < end; k++) {
            if (any) {
                if (nearestOf(s, order[k], r, best->t) <= best->t) {
                    return true;
                }
            } else {
                offer(s, r, order[k], best);
                limit = roundedUp(best->t);
            }
        }
    }
    return false;
}

// Whether a point of a face is near another face in the same place: which of them counts is decided by the host.
bool touchesOther(const Scene *s, const Hit *hit) {
    __global const int *p = primitive(s, hit->id);
    int count = p[CONTACT_COUNT];
    if (count < 0) {
        return true;
    }
    __global const double *b = s->d + p[CONTACTS];
    for (int k = 0; k < count; k++, b += 7) {
        if (b[0] == hit->face && hit->p.x >= b[1] && hit->p.y >= b[2] && hit->p.z >= b[3] && hit->p.x <= b[4] && hit->p.y <= b[5]
                && hit->p.z <= b[6]) {
            return true;
        }
    }
    return false;
}

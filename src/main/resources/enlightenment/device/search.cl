// What a ray meets: primitive.Primitive, accel.Closest, and hierarchies searched as accel.FloatBvh is. Boxes only cull.
double nearestOf(const Scene *s, int id, Ray *r, double tMax, bool any) {
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
        case MESH:
            return nearestMesh(s, q, r, own, tMax, any);
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
        case MESH:
            completeMesh(s, q, r, own, hit);
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
    } else if (kind == AXIAL) {
        placeOnAxial(q, hit, uv);
    } else {
        placeOnMesh(s, q, hit, uv);
    }
}

// Whether u is periodic: 0 and 1 are the same place.
bool repeats(const Scene *s, int id) {
    int kind = primitive(s, id)[KIND];
    return kind == SPHERE || kind == MESH || kind == TRIANGLE && numbersOf(s, id)[PLANE_SIZE + 9] != 0;
}

// accel.Closest
typedef struct {
    double t;
    int id;
    int element;
} Closest;

bool leavesAt(const Scene *s, Ray *r, int id, int element, double t) {
    Hit scratch;
    r->element = element;
    completeOf(s, id, r, t, &scratch);
    return scratch.side == INSIDE;
}

// Keeps a crossing of a primitive, if it is the closest: at equal t one that leaves a solid comes first, then the lower id.
void take(const Scene *s, Ray *r, int candidate, double t, Closest *best) {
    int element = r->element;
    bool isCloser = t < best->t;
    if (t == best->t) {
        isCloser = best->id == NOTHING;
        if (!isCloser) {
            bool leaves = leavesAt(s, r, candidate, element, t);
            bool known = leavesAt(s, r, best->id, best->element, t);
            isCloser = leaves == known ? candidate < best->id : leaves;
        }
    }
    if (isCloser) {
        best->t = t;
        best->id = candidate;
        best->element = element;
    }
}

// In the order of a hierarchy's leaves, what stands for all meshes that are searched together.
#define JOINED (-1)

void offer(const Scene *s, Ray *r, int item, Closest *best) {
    int id = item;
    double t = item == JOINED ? nearestUnion(s, r, best->t, false, &id) : nearestOf(s, item, r, best->t, false);
    if (t != MISS) {
        take(s, r, id, t, best);
    }
}

// Whether a crossing is the end of the ray: primitive.EndFaces.isEnd of the face of a light.
bool isEnd(const Scene *s, const Ray *r, int id, double t) {
    Hit hit;
    completeOf(s, id, r, t, &hit);
    double across = fabs(hit.n.x * r->dx + hit.n.y * r->dy + hit.n.z * r->dz);
    bool isFlat = (primitive(s, id)[TRAITS] & HAS_FLAT_FACES) != 0;
    return hit.face == r->endFace && (isFlat || (r->tEnd - t) * across <= r->endTolerance);
}

bool blocks(const Scene *s, Ray *r, int item, double tMax) {
    int id;
    double t = item == JOINED ? nearestUnion(s, r, tMax, true, &id) : nearestOf(s, item, r, tMax, true);
    return t <= tMax && !(item != JOINED && item == r->end && isEnd(s, r, item, t));
}

// The closest primitive that a ray meets; or, where any will do, whether it meets one that is no farther than the limit. Hierarchy 0 has meshes
// that are searched together as one item, hierarchy 1 has each of them.
bool search(Scene *s, Ray *r, bool any, int hierarchy, Closest *best) {
    int stack[MAX_DEPTH];
    float entries[MAX_DEPTH];
    Slabs slabs;
    if (!setSlabs(&slabs, r->ox, r->oy, r->oz, r->dx, r->dy, r->dz, r->dd, r->tMin, s->d[REACH + hierarchy])) {
        s->state = LEFT_TO_HOST;
        return false;
    }
    __global const float *boxes = s->f + s->i[BOXES + hierarchy];
    __global const int *child = s->i + s->i[CHILDREN + hierarchy];
    __global const int *order = s->i + s->i[ORDER + hierarchy];
    float limit = roundedUp(best->t);
    int depth = 1;
    stack[0] = 0;
    entries[0] = 0;
    while (depth > 0) {
        if (entries[--depth] > limit) {
            continue;
        }
        int node = nextLeaf(boxes, child, &slabs, stack[depth], limit, stack, entries, &depth);
        int first = (int) ((uint) ~node >> 3);
        int end = first + (~node & 7);
        for (int k = first; k < end; k++) {
            if (any) {
                if (blocks(s, r, order[k], best->t)) {
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

// Whether a border of glass may have been missed by a ray that leaves an opaque surface there.
bool isInGlassBox(const Scene *s, Vec p) {
    __global const double *b = s->d + s->i[GLASS_BOXES];
    for (int k = 0; k < s->i[GLASS_BOX_COUNT]; k++, b += 6) {
        if (p.x >= b[0] && p.y >= b[1] && p.z >= b[2] && p.x <= b[3] && p.y <= b[4] && p.z <= b[5]) {
            return true;
        }
    }
    return false;
}

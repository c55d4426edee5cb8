// Instances of meshes, and several that are searched together: mesh.MeshRay, primitive.Placing, MeshPrimitive and MeshUnion. Numbers of a
// mesh that is placed: the offset, the rows of its matrix and those of the inverse, whether it is only moved, the largest coordinate of the
// offset, the largest sum of a row of the inverse, the mesh, and its number in the union or -1. Of a union the first 25 alike, then where the
// number of the first triangle of each member stands among the integers, where the ids stand, and how many members there are.
#define INVERSE_ROWS 12
#define IS_MOVE 21
#define MAX_OFFSET 22
#define LARGEST_INVERSE 23
#define PLACED_MESH 24
#define MEMBER 25
#define FIRST_TRIANGLES 26
#define MEMBER_IDS 27
#define MEMBERS 28

double rowDot(__global const double *row, double x, double y, double z) {
    return fusedDot(row[0], row[1], row[2], x, y, z);
}

Vec placedVector(__global const double *q, Vec v) {
    if (q[IS_MOVE] != 0) {
        return v;
    }
    return vec(rowDot(q + 3, v.x, v.y, v.z), rowDot(q + 6, v.x, v.y, v.z), rowDot(q + 9, v.x, v.y, v.z));
}

// A normal of the mesh, of any length.
Vec placedNormal(__global const double *q, Vec n) {
    if (q[IS_MOVE] != 0) {
        return n;
    }
    __global const double *i = q + INVERSE_ROWS;
    return vec(fusedDot(i[0], i[3], i[6], n.x, n.y, n.z), fusedDot(i[1], i[4], i[7], n.x, n.y, n.z),
            fusedDot(i[2], i[5], i[8], n.x, n.y, n.z));
}

__global const int *meshOf(const Scene *s, __global const double *q) {
    return s->i + s->i[MESHES] + MESH_SIZE * (int) q[PLACED_MESH];
}

void placeMeshRay(const Scene *s, MeshRay *m, __global const double *q, const Ray *r) {
    m->s = s;
    m->mesh = meshOf(s, q);
    double x = r->ox - q[0];
    double y = r->oy - q[1];
    double z = r->oz - q[2];
    bool isMove = q[IS_MOVE] != 0;
    for (int axis = 0; axis < 3; axis++) {
        __global const double *row = q + INVERSE_ROWS + 3 * axis;
        m->o[axis] = isMove ? (axis == 0 ? x : axis == 1 ? y : z) : rowDot(row, x, y, z);
        m->d[axis] = isMove ? directionOf(r, axis) : rowDot(row, r->dx, r->dy, r->dz);
    }
    m->tMin = r->tMin;
    m->start = NO_TRIANGLE;
    m->tolerance = 0;
    directMeshRay(m);
}

// Where the ray enters the box of the mesh, at least from, a little early.
double entryOfMesh(const MeshRay *m, double tMax) {
    __global const double *q = m->s->d + m->mesh[MESH_NUMBERS];
    double off = m->start == NO_TRIANGLE ? 0 : m->tolerance;
    double from = m->tMin;
    double to = tMax;
    for (int axis = 0; axis < 3; axis++) {
        double low = q[LOW + axis] - m->o[axis];
        double high = q[HIGH + axis] - m->o[axis];
        double slack = EDGE_ERROR * (fabs(m->o[axis]) + q[LARGEST]) + off;
        double v = m->d[axis];
        if (v == 0) {
            if (low > slack || high < -slack) {
                return MISS;
            }
            continue;
        }
        double inverse = m->inverse[axis];
        double widened = slack * fabs(inverse);
        double first = smaller(low * inverse, high * inverse) - widened;
        double last = larger(low * inverse, high * inverse) + widened;
        from = first > from ? first : from;
        to = last < to ? last : to;
    }
    return from <= to ? from : MISS;
}

bool isBetter(const MeshRay *m, double t, double best, int triangle, int side) {
    return t < best || t == best && (m->t == MISS || (m->side == side ? triangle < m->triangle : m->side < side));
}

bool testMeshLeaf(MeshRay *m, int first, int end, double *best, int *side) {
    bool found = false;
    for (int k = first; k < end; k++) {
        int triangle = m->s->i[m->mesh[MESH_ORDER] + k];
        double t = testTriangle(m, triangle);
        if (isBetter(m, t, *best, triangle, *side)) {
            *best = t;
            m->t = t;
            m->triangle = triangle;
            *side = m->side;
            found = true;
        }
    }
    return found;
}

// Finds the closest triangle with t up to a limit, or any.
bool searchMesh(MeshRay *m, double tMax, bool any) {
    __global const double *q = m->s->d + m->mesh[MESH_NUMBERS];
    m->t = MISS;
    double entry = entryOfMesh(m, tMax);
    if (!(entry <= tMax)) {
        return false;
    }
    double unit = q[TREE_UNIT];
    double qx = m->d[0] * m->scale;
    double qy = m->d[1] * m->scale;
    double qz = m->d[2] * m->scale;
    Slabs slabs;
    if (!setSlabs(&slabs, fma(entry, m->d[0], m->o[0]) * unit, fma(entry, m->d[1], m->o[1]) * unit, fma(entry, m->d[2], m->o[2]) * unit,
                qx, qy, qz, qx * qx + qy * qy + qz * qz, 0, q[TREE_REACH])) {
        return false;
    }
    double scale = unit / m->scale;
    double best = tMax;
    int side = 0;
    int stack[MAX_DEPTH];
    float entries[MAX_DEPTH];
    float limit = roundedUp((best - entry) * scale);
    int depth = 1;
    stack[0] = 0;
    entries[0] = 0;
    while (depth > 0) {
        if (entries[--depth] > limit) {
            continue;
        }
        int node = nextLeaf(m->s->f + m->mesh[MESH_BOXES], m->s->i + m->mesh[MESH_CHILDREN], &slabs, stack[depth], limit, stack, entries,
                &depth);
        int first = (int) ((uint) ~node >> 3);
        if (testMeshLeaf(m, first, first + (~node & 7), &best, &side)) {
            if (any) {
                return true;
            }
            limit = roundedUp((best - entry) * scale);
        }
    }
    return m->t != MISS;
}

void startOnMesh(MeshRay *m, __global const double *q, int triangle, const Ray *r, double largestInverse) {
    double size = larger(fabs(r->ox), larger(fabs(r->oy), fabs(r->oz))) + q[MAX_OFFSET];
    startOnTriangle(m, triangle, r->startSide, GAMMA(16) * size * largestInverse);
}

void meshRay(const Scene *s, MeshRay *m, __global const double *q, const Ray *r, bool own) {
    placeMeshRay(s, m, q, r);
    if (own) {
        startOnMesh(m, q, r->startElement, r, q[LARGEST_INVERSE]);
    }
}

double nearestMesh(const Scene *s, __global const double *q, Ray *r, bool own, double tMax, bool any) {
    MeshRay m;
    meshRay(s, &m, q, r, own);
    if (!searchMesh(&m, tMax, any)) {
        return MISS;
    }
    r->element = m.triangle;
    return m.t;
}

// The closest crossing of the members of a union; sets the element and the member's id.
double nearestUnion(const Scene *s, Ray *r, double tMax, bool any, int *id) {
    __global const double *q = s->d + s->i[UNION];
    __global const int *first = s->i + (int) q[FIRST_TRIANGLES];
    MeshRay m;
    placeMeshRay(s, &m, q, r);
    if (r->start != NOTHING && primitive(s, r->start)[KIND] == MESH) {
        __global const double *own = numbersOf(s, r->start);
        int member = (int) own[MEMBER];
        if (member >= 0) {
            startOnMesh(&m, own, first[member] + r->startElement, r, q[LARGEST_INVERSE]);
        }
    }
    if (!searchMesh(&m, tMax, any)) {
        return MISS;
    }
    int low = 0;
    int high = (int) q[MEMBERS];
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (first[middle] <= m.triangle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    r->element = m.triangle - first[low];
    *id = s->i[(int) q[MEMBER_IDS] + low];
    return m.t;
}

double weighted(double p, double q, double r, double a, double b, double c) {
    return fma(c, r, fma(b, q, a * p));
}

double clampedWeight(double w) {
    return w > 0 ? smaller(w, 1) : 0;
}

// A vector times the power of two that brings its largest component into [1, 2).
Vec scaledToOne(Vec v) {
    double size = sizeOf(v.x, v.y, v.z);
    int e = -ilogb(size);
    return vec(ldexp(v.x, e), ldexp(v.y, e), ldexp(v.z, e));
}

Vec unitVector(Vec v) {
    Vec w = scaledToOne(v);
    double s = 1 / sqrt(fusedDot(w.x, w.y, w.z, w.x, w.y, w.z));
    return vec(w.x * s, w.y * s, w.z * s);
}

void completeMesh(const Scene *s, __global const double *q, const Ray *r, bool own, Hit *hit) {
    MeshRay m;
    meshRay(s, &m, q, r, own);
    int triangle = r->element;
    coversTriangle(&m, triangle);
    planeOfTriangle(&m);
    hit->side = towardsTriangle(&m) < 0 ? 1 : -1;
    double sum = m.e0 + m.e1 + m.e2;
    double wb = sum == 0 ? 0 : clampedWeight(m.e2 / sum);
    double wc = sum == 0 ? 0 : clampedWeight(m.e0 / sum);
    hit->element = triangle;
    hit->face = 0;
    hit->weightB = wb;
    hit->weightC = wc;
    double wa = 1 - wb - wc;
    Vec a = positionOf(&m, cornerOf(&m, triangle, 0));
    Vec b = positionOf(&m, cornerOf(&m, triangle, 1));
    Vec c = positionOf(&m, cornerOf(&m, triangle, 2));
    double x = weighted(a.x, b.x, c.x, wa, wb, wc);
    double y = weighted(a.y, b.y, c.y, wa, wb, wc);
    double z = weighted(a.z, b.z, c.z, wa, wb, wc);
    hit->p = vec(q[0] + rowDot(q + 3, x, y, z), q[1] + rowDot(q + 6, x, y, z), q[2] + rowDot(q + 9, x, y, z));
    Vec n = scaledToOne(placedNormal(q, areaNormal(&m, triangle)));
    setNormal(hit, n.x, n.y, n.z);
}

void placeOnMesh(const Scene *s, __global const double *q, const Hit *hit, double *uv) {
    __global const int *mesh = meshOf(s, q);
    if (mesh[UV] < 0) {
        uv[0] = hit->weightB;
        uv[1] = 1 - hit->weightC;
        return;
    }
    double a = 1 - hit->weightB - hit->weightC;
    __global const int *v = s->i + mesh[CORNERS] + 3 * hit->element;
    __global const float *f = s->f + mesh[UV];
    uv[0] = weighted(f[2 * v[0]], f[2 * v[1]], f[2 * v[2]], a, hit->weightB, hit->weightC);
    uv[1] = 1 - weighted(f[2 * v[0] + 1], f[2 * v[1] + 1], f[2 * v[2] + 1], a, hit->weightB, hit->weightC);
}

Vec vertexNormal(const Scene *s, __global const int *mesh, const Hit *hit, int k) {
    __global const float *n = s->f + mesh[NORMALS] + 3 * s->i[mesh[CORNERS] + 3 * hit->element + k];
    return vec(n[0], n[1], n[2]);
}

// The normal that the surface is shaded by, where it is another one than its own.
bool shadingNormal(const Scene *s, const Hit *hit, Vec *out) {
    if (primitive(s, hit->id)[KIND] != MESH) {
        return false;
    }
    __global const double *q = numbersOf(s, hit->id);
    __global const int *mesh = meshOf(s, q);
    if (mesh[NORMALS] < 0) {
        return false;
    }
    double a = 1 - hit->weightB - hit->weightC;
    Vec p = vertexNormal(s, mesh, hit, 0);
    Vec b = vertexNormal(s, mesh, hit, 1);
    Vec c = vertexNormal(s, mesh, hit, 2);
    Vec n = placedNormal(q, vec(weighted(p.x, b.x, c.x, a, hit->weightB, hit->weightC), weighted(p.y, b.y, c.y, a, hit->weightB, hit->weightC),
                                    weighted(p.z, b.z, c.z, a, hit->weightB, hit->weightC)));
    if (!(sizeOf(n.x, n.y, n.z) > 0)) {
        return false;
    }
    n = unitVector(scaledToOne(n));
    if (!(n.x * hit->n.x + n.y * hit->n.y + n.z * hit->n.z > 0)) {
        return false;
    }
    *out = n;
    return true;
}

// The offset to where the surface would be if it were as smooth as its shading normals say.
Vec bulgeOf(const Scene *s, const Hit *hit) {
    __global const double *q = numbersOf(s, hit->id);
    __global const int *mesh = meshOf(s, q);
    MeshRay m;
    m.s = s;
    m.mesh = mesh;
    double weights[3] = {1 - hit->weightB - hit->weightC, hit->weightB, hit->weightC};
    Vec corners[3];
    Vec at = vec(0, 0, 0);
    for (int k = 0; k < 3; k++) {
        corners[k] = positionOf(&m, cornerOf(&m, hit->element, k));
        at = vec(at.x + corners[k].x * weights[k], at.y + corners[k].y * weights[k], at.z + corners[k].z * weights[k]);
    }
    Vec sum = vec(0, 0, 0);
    for (int k = 0; k < 3; k++) {
        Vec n = vertexNormal(s, mesh, hit, k);
        if (sizeOf(n.x, n.y, n.z) > 0) {
            Vec w = unitVector(n);
            Vec unit = vec(w.x * hit->side, w.y * hit->side, w.z * hit->side);
            Vec off = vec(at.x - corners[k].x, at.y - corners[k].y, at.z - corners[k].z);
            double below = smaller(0, fusedDot(off.x, off.y, off.z, unit.x, unit.y, unit.z));
            double by = weights[k] * below;
            sum = vec(sum.x - unit.x * by, sum.y - unit.y * by, sum.z - unit.z * by);
        }
    }
    return placedVector(q, sum);
}

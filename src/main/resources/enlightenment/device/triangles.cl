// One ray against the triangles of a mesh, in the mesh's coordinates: mesh.TriangleTest and mesh.Departure.
#define NO_TRIANGLE (-1)
#define NEAR_ERRORS 4
#define ROUNDED GAMMA(16)
#define NO_EDGE (-1)
#define ALL_SHARED 3

// A mesh among the integers: where its vertices are (floats, or else doubles), the corners of triangles, normals and texture coordinates of
// vertices (or -1), its numbers, and its hierarchy: boxes, links, and the triangles in the order of the leaves.
#define MESH_SIZE 9
#define FLOAT_POSITIONS 0
#define DOUBLE_POSITIONS 1
#define CORNERS 2
#define NORMALS 3
#define UV 4
#define MESH_NUMBERS 5
#define MESH_BOXES 6
#define MESH_CHILDREN 7
#define MESH_ORDER 8

// Numbers of a mesh: least and greatest coordinates, the unit of its hierarchy and that one's reach, and its largest coordinate.
#define LOW 0
#define HIGH 3
#define TREE_UNIT 6
#define TREE_REACH 7
#define LARGEST 8

typedef struct {
    const Scene *s;
    __global const int *mesh;
    double o[3];
    double d[3];
    double inverse[3];
    double scale;
    double tMin;
    int kx;
    int ky;
    int kz;
    double shearX;
    double shearY;
    // The triangle that the ray starts on, the side that it travels on, how far off the origin may be, and the corner it cannot be told from.
    int start;
    int startSide;
    double tolerance;
    int corner;
    double near;
    Vec startA;
    Vec startB;
    Vec startC;
    // The triangle that is being tested: corners relative to the origin with the axes turned, edge functions, normal.
    Vec a;
    Vec b;
    Vec c;
    double e0;
    double e1;
    double e2;
    Vec n;
    int side;
    // Of the last neighbour that was looked at: the corner of the start triangle, and its own, that are not shared.
    int opposite;
    int unshared;
    // The closest crossing.
    double t;
    int triangle;
} MeshRay;

int cornerOf(const MeshRay *m, int triangle, int k) {
    return m->s->i[m->mesh[CORNERS] + 3 * triangle + k];
}

double coordinateOf(const MeshRay *m, int vertex, int axis) {
    int at = 3 * vertex + axis;
    return m->mesh[FLOAT_POSITIONS] >= 0 ? (double) m->s->f[m->mesh[FLOAT_POSITIONS] + at] : m->s->d[m->mesh[DOUBLE_POSITIONS] + at];
}

Vec positionOf(const MeshRay *m, int vertex) {
    return vec(coordinateOf(m, vertex, 0), coordinateOf(m, vertex, 1), coordinateOf(m, vertex, 2));
}

double sizeOf(double x, double y, double z) {
    return larger(fabs(x), larger(fabs(y), fabs(z)));
}

void directMeshRay(MeshRay *m) {
    for (int axis = 0; axis < 3; axis++) {
        m->inverse[axis] = 1 / m->d[axis];
    }
    double sx = fabs(m->d[0]);
    double sy = fabs(m->d[1]);
    double sz = fabs(m->d[2]);
    m->kz = sx > sy ? (sx > sz ? 0 : 2) : (sy > sz ? 1 : 2);
    m->kx = m->kz == 2 ? 0 : m->kz + 1;
    m->ky = m->kx == 2 ? 0 : m->kx + 1;
    m->scale = 1 / ldexp(1.0, ilogb(m->d[m->kz]));
    m->shearX = m->d[m->kx] * m->inverse[m->kz];
    m->shearY = m->d[m->ky] * m->inverse[m->kz];
}

Vec turnedCorner(const MeshRay *m, int vertex) {
    return vec(coordinateOf(m, vertex, m->kx) - m->o[m->kx], coordinateOf(m, vertex, m->ky) - m->o[m->ky],
            coordinateOf(m, vertex, m->kz) - m->o[m->kz]);
}

void loadTriangle(MeshRay *m, int triangle) {
    m->a = turnedCorner(m, cornerOf(m, triangle, 0));
    m->b = turnedCorner(m, cornerOf(m, triangle, 1));
    m->c = turnedCorner(m, cornerOf(m, triangle, 2));
}

bool isNearOrigin(Vec v, double near) {
    return fabs(v.x) <= near && fabs(v.y) <= near && fabs(v.z) <= near;
}

void startOnTriangle(MeshRay *m, int triangle, int side, double error) {
    double largest = m->s->d[m->mesh[MESH_NUMBERS] + LARGEST];
    m->start = triangle;
    m->startSide = side;
    m->tolerance = error + ROUNDED * largest;
    loadTriangle(m, triangle);
    m->startA = m->a;
    m->startB = m->b;
    m->startC = m->c;
    double near = NEAR_ERRORS * m->tolerance;
    m->corner = isNearOrigin(m->c, near) ? 2 : isNearOrigin(m->b, near) ? 1 : isNearOrigin(m->a, near) ? 0 : -1;
    double far = 2 * (largest + sizeOf(m->o[m->kx], m->o[m->ky], m->o[m->kz]));
    m->near = NEAR_ERRORS * (m->tolerance + EDGE_ERROR * far) * far;
}

bool coversTriangle(MeshRay *m, int triangle) {
    loadTriangle(m, triangle);
    double px = fma(-m->shearX, m->a.z, m->a.x);
    double py = fma(-m->shearY, m->a.z, m->a.y);
    double qx = fma(-m->shearX, m->b.z, m->b.x);
    double qy = fma(-m->shearY, m->b.z, m->b.y);
    double rx = fma(-m->shearX, m->c.z, m->c.x);
    double ry = fma(-m->shearY, m->c.z, m->c.y);
    m->e0 = difference(px, qy, py, qx);
    m->e1 = difference(qx, ry, qy, rx);
    m->e2 = difference(rx, py, ry, px);
    return covers(m->e0, m->e1, m->e2);
}

bool isSame(Vec v, Vec w) {
    return v.x == w.x && v.y == w.y && v.z == w.z;
}

bool touchesStart(const MeshRay *m) {
    return isSame(m->startA, m->a) || isSame(m->startA, m->b) || isSame(m->startA, m->c) || isSame(m->startB, m->a)
            || isSame(m->startB, m->b) || isSame(m->startB, m->c) || isSame(m->startC, m->a) || isSame(m->startC, m->b)
            || isSame(m->startC, m->c);
}

double betweenCorners(const MeshRay *m, double area) {
    double inverse = m->inverse[m->kz];
    double ta = m->a.z * inverse;
    double tb = m->b.z * inverse;
    double tc = m->c.z * inverse;
    double lo = smaller(ta, smaller(tb, tc));
    double hi = larger(ta, larger(tb, tc));
    double t = (m->e1 * ta + m->e2 * tb + m->e0 * tc) / area;
    return t < lo ? lo : t > hi ? hi : t;
}

double edgeSize(Vec from, Vec to) {
    return sizeOf(to.x - from.x, to.y - from.y, to.z - from.z);
}

bool mayBeInPlane(const MeshRay *m, double height) {
    double edges = edgeSize(m->a, m->b) * edgeSize(m->a, m->c);
    double near = m->tolerance + EDGE_ERROR * sizeOf(m->a.x, m->a.y, m->a.z);
    return fabs(height) <= 2 * 3 * 2 * edges * near;
}

double reachOf(const MeshRay *m) {
    return larger(sizeOf(m->a.x, m->a.y, m->a.z), larger(sizeOf(m->b.x, m->b.y, m->b.z), sizeOf(m->c.x, m->c.y, m->c.z)));
}

double planeOfTriangle(MeshRay *m) {
    Vec u = vec(m->b.x - m->a.x, m->b.y - m->a.y, m->b.z - m->a.z);
    Vec v = vec(m->c.x - m->a.x, m->c.y - m->a.y, m->c.z - m->a.z);
    m->n = vec(difference(u.y, v.z, u.z, v.y), difference(u.z, v.x, u.x, v.z), difference(u.x, v.y, u.y, v.x));
    return accurateDot(m->n.x, m->n.y, m->n.z, m->a.x, m->a.y, m->a.z);
}

double towardsTriangle(const MeshRay *m) {
    return accurateDot(m->n.x, m->n.y, m->n.z, m->d[m->kx], m->d[m->ky], m->d[m->kz]);
}

// The geometric normal of a triangle, as long as twice its area.
Vec areaNormal(const MeshRay *m, int triangle) {
    Vec a = positionOf(m, cornerOf(m, triangle, 0));
    Vec b = positionOf(m, cornerOf(m, triangle, 1));
    Vec c = positionOf(m, cornerOf(m, triangle, 2));
    Vec u = vec(b.x - a.x, b.y - a.y, b.z - a.z);
    Vec v = vec(c.x - a.x, c.y - a.y, c.z - a.z);
    return vec(difference(u.y, v.z, u.z, v.y), difference(u.z, v.x, u.x, v.z), difference(u.x, v.y, u.y, v.x));
}

double alongNormal(const MeshRay *m, Vec n, int from, int to) {
    Vec p = positionOf(m, from);
    Vec q = positionOf(m, to);
    return accurateDot(n.x, n.y, n.z, q.x - p.x, q.y - p.y, q.z - p.z);
}

bool isInStartPlane(const MeshRay *m, int triangle) {
    Vec n = areaNormal(m, m->start);
    double size = fabs(n.x) + fabs(n.y) + fabs(n.z);
    double largest = m->s->d[m->mesh[MESH_NUMBERS] + LARGEST];
    for (int k = 0; k < 3; k++) {
        double h = alongNormal(m, n, cornerOf(m, m->start, 0), cornerOf(m, triangle, k));
        if (!(fabs(h) <= ROUNDED * size * largest)) {
            return false;
        }
    }
    return true;
}

bool isInPlane(MeshRay *m, int triangle) {
    double height = planeOfTriangle(m);
    double reach = reachOf(m);
    double near = m->tolerance + EDGE_ERROR * reach;
    double edges = edgeSize(m->a, m->b) + edgeSize(m->a, m->c);
    double n = fabs(m->n.x) + fabs(m->n.y) + fabs(m->n.z);
    bool isAtStart = fabs(height) <= n * near + EDGE_ERROR * reach * edges * sizeOf(m->a.x, m->a.y, m->a.z);
    return isAtStart && isInStartPlane(m, triangle);
}

double distanceToTriangle(MeshRay *m, int triangle) {
    double area = m->e0 + m->e1 + m->e2;
    double dz = m->d[m->kz];
    m->side = area * dz < 0 ? 1 : -1;
    double t = betweenCorners(m, area);
    if (!(t >= m->tMin) || m->start != NO_TRIANGLE && mayBeInPlane(m, t * area * dz) && isInPlane(m, triangle)) {
        return MISS;
    }
    return t;
}

bool areInOnePlace(const MeshRay *m, int v, int w) {
    return v == w || isSame(positionOf(m, v), positionOf(m, w));
}

int sharedEdge(MeshRay *m, int triangle) {
    int shared = 0;
    int left = 0;
    m->opposite = 3;
    for (int k = 0; k < 3; k++) {
        int v = cornerOf(m, triangle, k);
        int own = areInOnePlace(m, cornerOf(m, m->start, 0), v) ? 0
                : areInOnePlace(m, cornerOf(m, m->start, 1), v) ? 1
                : areInOnePlace(m, cornerOf(m, m->start, 2), v) ? 2
                                                                : -1;
        if (own < 0) {
            left = k;
        } else {
            shared++;
            m->opposite -= own;
        }
    }
    m->unshared = left;
    return shared == 3 ? ALL_SHARED : shared == 2 ? (left + 1) % 3 : NO_EDGE;
}

double signOf(double v) {
    return v > 0 ? 1.0 : v < 0 ? -1.0 : v;
}

bool meetsNeighbour(const MeshRay *m, int triangle, int edge, double towards) {
    Vec own = areaNormal(m, m->start);
    double height = alongNormal(m, own, cornerOf(m, m->start, 0), cornerOf(m, triangle, m->unshared));
    if (!(m->startSide * height > 0)) {
        return false;
    }
    Vec n = areaNormal(m, triangle);
    double side = alongNormal(m, n, cornerOf(m, triangle, (m->unshared + 1) % 3), cornerOf(m, m->start, m->opposite));
    if (!(towards * side < 0)) {
        return false;
    }
    double sign = signOf(towards) * signOf(m->d[m->kz]);
    return (edge == 0 || sign * m->e0 >= 0) && (edge == 1 || sign * m->e1 >= 0) && (edge == 2 || sign * m->e2 >= 0);
}

bool isInFan(MeshRay *m, int triangle, int k) {
    planeOfTriangle(m);
    double towards = towardsTriangle(m);
    m->side = towards < 0 ? 1 : -1;
    double g[3];
    for (int axis = 0; axis < 3; axis++) {
        g[axis] = (coordinateOf(m, cornerOf(m, m->start, 0), axis) + coordinateOf(m, cornerOf(m, m->start, 1), axis)
                          + coordinateOf(m, cornerOf(m, m->start, 2), axis))
                / 3;
    }
    Vec v = positionOf(m, cornerOf(m, triangle, k));
    Vec next = positionOf(m, cornerOf(m, triangle, (k + 1) % 3));
    Vec last = positionOf(m, cornerOf(m, triangle, (k + 2) % 3));
    double vx = component(v, m->kx) - g[m->kx];
    double vy = component(v, m->ky) - g[m->ky];
    double vz = component(v, m->kz) - g[m->kz];
    double height = accurateDot(m->n.x, m->n.y, m->n.z, vx, vy, vz);
    if (!(height * towards > 0)) {
        return false;
    }
    double px = fma(-m->shearX, vz, vx);
    double py = fma(-m->shearY, vz, vy);
    double nextZ = component(next, m->kz) - g[m->kz];
    double qx = fma(-m->shearX, nextZ, component(next, m->kx) - g[m->kx]);
    double qy = fma(-m->shearY, nextZ, component(next, m->ky) - g[m->ky]);
    double lastZ = component(last, m->kz) - g[m->kz];
    double rx = fma(-m->shearX, lastZ, component(last, m->kx) - g[m->kx]);
    double ry = fma(-m->shearY, lastZ, component(last, m->ky) - g[m->ky]);
    double sign = signOf(towards) * signOf(m->d[m->kz]);
    return sign * difference(px, qy, py, qx) >= 0 && sign * difference(rx, py, ry, px) >= 0;
}

// The t of a triangle that touches the one that the ray starts on.
double leavingStart(MeshRay *m, int triangle, bool covered) {
    if (m->corner >= 0) {
        int place = cornerOf(m, m->start, m->corner);
        for (int k = 0; k < 3; k++) {
            if (areInOnePlace(m, place, cornerOf(m, triangle, k))) {
                return isInFan(m, triangle, k) ? m->tMin : MISS;
            }
        }
    }
    int edge = sharedEdge(m, triangle);
    if (edge == ALL_SHARED) {
        return MISS;
    }
    if (edge < 0) {
        return covered ? distanceToTriangle(m, triangle) : MISS;
    }
    double reach = reachOf(m);
    double near = m->tolerance + EDGE_ERROR * reach;
    if (!covered && !(smaller(fabs(m->e0), smaller(fabs(m->e1), fabs(m->e2))) <= NEAR_ERRORS * near * reach)) {
        return MISS;
    }
    double height = planeOfTriangle(m);
    double towards = towardsTriangle(m);
    m->side = towards < 0 ? 1 : -1;
    if (!meetsNeighbour(m, triangle, edge, towards)) {
        return MISS;
    }
    double t = covered ? betweenCorners(m, m->e0 + m->e1 + m->e2) : height / towards;
    double inverse = m->inverse[m->kz];
    double hi = larger(m->a.z * inverse, larger(m->b.z * inverse, m->c.z * inverse));
    return larger(m->tMin, smaller(t, hi));
}

double testTriangle(MeshRay *m, int triangle) {
    if (triangle == m->start) {
        return MISS;
    }
    bool covered = coversTriangle(m, triangle);
    if (m->start != NO_TRIANGLE) {
        bool isNear = m->corner >= 0 || fabs(m->e0) <= m->near || fabs(m->e1) <= m->near || fabs(m->e2) <= m->near;
        if ((covered || isNear) && touchesStart(m)) {
            return leavingStart(m, triangle, covered);
        }
    }
    return covered ? distanceToTriangle(m, triangle) : MISS;
}

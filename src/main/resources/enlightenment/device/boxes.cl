// Rays against boxes of floats: bvh.FloatSlabs and bvh.Nodes.
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

bool setSlabs(Slabs *b, double ox, double oy, double oz, double dx, double dy, double dz, double dd, double from, double reach) {
    double o = larger(fabs(ox), larger(fabs(oy), fabs(oz)));
    if (!(dd >= 0x1p-40 && dd <= 0x1p40 && o <= 2 * reach && from >= 0)) {
        return false;
    }
    b->invX = inverseOf(dx);
    b->invY = inverseOf(dy);
    b->invZ = inverseOf(dz);
    b->offsetX = (float) (-ox * b->invX);
    b->offsetY = (float) (-oy * b->invY);
    b->offsetZ = (float) (-oz * b->invZ);
    b->tMin = fmax(0.0f, roundedDown(from));
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

#define MAX_DEPTH 64
#define NODE 12
#define EMPTY_LEAF (~0)

// Follows links from a node to the nearest leaf, and keeps those that are to be followed later.
int nextLeaf(__global const float *boxes, __global const int *child, const Slabs *slabs, int from, float limit, int *stack, float *entries,
        int *depth) {
    int node = from;
    while (node >= 0) {
        float l = entryOf(slabs, boxes + NODE * node, limit);
        float r = entryOf(slabs, boxes + NODE * node + 1, limit);
        int nearer = l <= r ? 0 : 1;
        int link = 2 * node;
        node = child[link + nearer];
        if (fmax(l, r) < (float) INFINITY) {
            entries[*depth] = fmax(l, r);
            stack[(*depth)++] = child[link + 1 - nearer];
        } else if (fmin(l, r) == (float) INFINITY) {
            node = EMPTY_LEAF;
        }
    }
    return node;
}

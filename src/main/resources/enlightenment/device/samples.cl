// Samples of pixels and their random numbers: sampling.SobolSampler. And what every kernel does for a sample before and after it is shaded.
typedef struct {
    int column;
    int row;
    ulong pixelHash;
    // The number of the sample in its pixel, and what the hashes of that have in common.
    uint sample;
    ulong sampleHash;
} Sampler;

// sampling.Sampler.Purpose
#define DIRECTION 0
#define CHOICE 1
#define ROULETTE 2
#define LIGHT_POINT 3
#define LENS_POINT 15

#define STRATIFIED_BOUNCES 2
#define SINGLE_NUMBER (1UL << 40)

Sampler samplerOf(ulong seed, int column, int row, uint sample) {
    Sampler s;
    s.column = column;
    s.row = row;
    s.pixelHash = hashOf(hashOf(seed, (ulong) column), (ulong) row);
    s.sample = sample;
    s.sampleHash = hashOf(~s.pixelHash, (ulong) sample);
    return s;
}

ulong addressOf(int bounce, int purpose) {
    return (ulong) (purpose + 1) << 32 | (ulong) bounce;
}

// A single number, 0..1.
double unitOf(const Sampler *s, int bounce, int purpose) {
    return (double) (mixed(s->sampleHash + (addressOf(bounce, purpose) | SINGLE_NUMBER) * GOLDEN_GAMMA) >> 11) * 0x1p-53;
}

// A point of the unit square.
double2 pairOf(const Sampler *s, int bounce, int purpose) {
    ulong address = addressOf(bounce, purpose);
    if (bounce >= STRATIFIED_BOUNCES) {
        ulong h = mixed(s->sampleHash + address * GOLDEN_GAMMA);
        return (double2)((double) (h >> 32) * 0x1p-32, (double) (h & 0xFFFFFFFFUL) * 0x1p-32);
    }
    ulong seed = hashOf(s->pixelHash, address);
    uint index = shuffledIndex(s->sample, mixed(seed));
    return (double2)(sobolX(index, seed), sobolY(index, seed));
}

ulong seedOfLight(const Sampler *s, int light, int bounce) {
    return hashOf(hashOf(s->pixelHash, 1 + (ulong) light), (ulong) bounce);
}

// The only point of a light, where one is taken of each.
double2 pairOfLight(const Sampler *s, int light, int bounce) {
    ulong seed = seedOfLight(s, light, bounce);
    uint index = shuffledIndex(s->sample, mixed(seed));
    return (double2)(sobolX(index, seed), sobolY(index, seed));
}

void beginScene(Scene *s, __global const double *doubles, __global const int *ints, __global const float *floats) {
    s->d = doubles;
    s->i = ints;
    s->f = floats;
    s->state = DONE;
    s->shadowRays = 0;
    s->mirrorRays = 0;
    s->refractedRays = 0;
    s->lightSamples = 0;
    s->textureLookups = 0;
}

// The pixel of the tile that a sample is in.
int pixelOf(__global const int *start, int pixels, int item) {
    int low = 0;
    int high = pixels;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (start[middle] <= item) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

// A point of the aperture: world.camera.Aperture. The corners stand behind the lens.
double2 pointOfAperture(const Scene *s, __global const double *lens, double2 u) {
    int corners = s->i[LENS_CORNERS];
    if (corners == 0) {
        Vec disk = toDisk(u.x, u.y);
        return (double2)(disk.x, disk.y);
    }
    int blades = corners - 1;
    int k = min((int) (u.x * blades), blades - 1);
    double off = sqrt(u.x * blades - k);
    __global const double *x = lens + 12 + k;
    __global const double *y = x + corners;
    return (double2)(off * ((1 - u.y) * x[0] + u.y * x[1]), off * ((1 - u.y) * y[0] + u.y * y[1]));
}

// Moves the ray through the middle of the lens to a sampled point of it: world.camera.ThinLens.
void moveToLens(Scene *s, Ray *r, const Sampler *sampler, double from) {
    __global const double *q = s->d + s->i[LENS];
    double2 p = pointOfAperture(s, q, pairOf(sampler, 0, LENS_POINT));
    setRay(s, r, q[0] * p.x + q[3] * p.y, q[1] * p.x + q[4] * p.y, q[2] * p.x + q[5] * p.y, r->dx - (q[6] * p.x + q[9] * p.y),
            r->dy - (q[7] * p.x + q[10] * p.y), r->dz - (q[8] * p.x + q[11] * p.y), from);
}

void setCameraRay(Scene *s, Ray *r, const Sampler *sampler) {
    ulong filmSeed = hashOf(sampler->pixelHash, 0);
    double x = (sampler->column + sobolX(sampler->sample, filmSeed)) / s->d[WIDTH];
    double y = (sampler->row + sobolY(sampler->sample, filmSeed)) / s->d[HEIGHT];
    __global const double *c = s->d + CAMERA;
    setRay(s, r, fma(x, c[3], fma(y, c[6], c[0])), fma(x, c[4], fma(y, c[7], c[1])), fma(x, c[5], fma(y, c[8], c[2])),
            fma(x, c[12], fma(y, c[15], c[9])), fma(x, c[13], fma(y, c[16], c[10])), fma(x, c[14], fma(y, c[17], c[11])), c[18]);
    if (s->i[LENS] != 0) {
        moveToLens(s, r, sampler, c[18]);
    }
}

void finish(const Scene *s, Vec light, int place, __global double *rgb, __global int *states, __global int *counts) {
    rgb[3 * place] = light.x;
    rgb[3 * place + 1] = light.y;
    rgb[3 * place + 2] = light.z;
    states[place] = s->state;
    if (s->state == DONE) {
        atomic_add(counts, s->shadowRays);
        atomic_add(counts + 1, s->mirrorRays);
        atomic_add(counts + 2, s->refractedRays);
        atomic_add(counts + 3, s->lightSamples);
        atomic_add(counts + 4, s->textureLookups);
    }
}

// Numbers as the Java code computes them, operation by operation: nothing is contracted, and where Java's rules differ from C's (the
// larger of two zeros, NaN), Java's are written out.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

// math.Vec3
typedef struct {
    double x;
    double y;
    double z;
} Vec;

Vec vec(double x, double y, double z) {
    Vec v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

Vec vecAt(__global const double *d) {
    return vec(d[0], d[1], d[2]);
}

double component(Vec v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// java.lang.Math.max
double larger(double a, double b) {
    if (a != a) {
        return a;
    }
    if (a == 0 && b == 0) {
        return signbit(a) ? b : a;
    }
    return a >= b ? a : b;
}

// java.lang.Math.min
double smaller(double a, double b) {
    if (a != a) {
        return a;
    }
    if (a == 0 && b == 0) {
        return signbit(a) ? a : b;
    }
    return a <= b ? a : b;
}

// numeric.Scale.gamma
#define GAMMA(n) ((n) * 0x1p-53 / (1 - (n) * 0x1p-53))

// numeric.Exponential
double powerOfTwo(int n) {
    return as_double((long) (n + 1023) << 52);
}

double expOf(double x) {
    if (!(x >= -746 && x <= 710)) {
        return x < 0 ? 0 : x > 0 ? INFINITY : x;
    }
    double k = floor(fma(x, 1.4426950408889634, 0.5));
    double r = fma(k, -2.3190468138462996e-17, fma(k, -0.6931471805599453, x));
    double s = r * r;
    double even = fma(s, 1.0 / 479001600, 1.0 / 3628800);
    double odd = fma(s, 1.0 / 6227020800L, 1.0 / 39916800);
    even = fma(s, even, 1.0 / 40320);
    odd = fma(s, odd, 1.0 / 362880);
    even = fma(s, even, 1.0 / 720);
    odd = fma(s, odd, 1.0 / 5040);
    even = fma(s, even, 1.0 / 24);
    odd = fma(s, odd, 1.0 / 120);
    even = fma(s, even, 0.5);
    odd = fma(s, odd, 1.0 / 6);
    double rest = fma(s, fma(r, odd, even), r);
    int first = (int) k >> 1;
    return (rest + 1) * powerOfTwo(first) * powerOfTwo((int) k - first);
}

// numeric.Products
double difference(double a, double b, double c, double d) {
    double cd = c * d;
    double error = fma(-c, d, cd);
    return fma(a, b, -cd) + error;
}

double fusedDot(double ax, double ay, double az, double bx, double by, double bz) {
    return fma(az, bz, fma(ay, by, ax * bx));
}

double accurateDot(double ax, double ay, double az, double bx, double by, double bz) {
    double p = ax * bx;
    double s = fma(ax, bx, -p);
    double h = ay * by;
    double r = fma(ay, by, -h);
    double sum = p + h;
    double t = sum - p;
    s += ((p - (sum - t)) + (h - t)) + r;
    p = sum;
    h = az * bz;
    r = fma(az, bz, -h);
    sum = p + h;
    t = sum - p;
    s += ((p - (sum - t)) + (h - t)) + r;
    return sum + s;
}

double distanceSquaredMinus(double x, double y, double z, double r) {
    double p = x * x;
    double s = fma(x, x, -p);
    double h = y * y;
    double e = fma(y, y, -h);
    double sum = p + h;
    double t = sum - p;
    s += ((p - (sum - t)) + (h - t)) + e;
    p = sum;
    h = z * z;
    e = fma(z, z, -h);
    sum = p + h;
    t = sum - p;
    s += ((p - (sum - t)) + (h - t)) + e;
    p = sum;
    h = -r * r;
    e = fma(-r, r, -h);
    sum = p + h;
    t = sum - p;
    s += ((p - (sum - t)) + (h - t)) + e;
    return sum + s;
}

// numeric.Arcs
double sineNearZero(double x) {
    double z = x * x;
    double p = fma(z, 1.0 / 355687428096000.0, -1.0 / 1307674368000.0);
    p = fma(z, p, 1.0 / 6227020800.0);
    p = fma(z, p, -1.0 / 39916800.0);
    p = fma(z, p, 1.0 / 362880.0);
    p = fma(z, p, -1.0 / 5040.0);
    p = fma(z, p, 1.0 / 120.0);
    p = fma(z, p, -1.0 / 6.0);
    return fma(z * x, p, x);
}

double cosineNearZero(double x) {
    double z = x * x;
    double p = fma(z, -1.0 / 6402373705728000.0, 1.0 / 20922789888000.0);
    p = fma(z, p, -1.0 / 87178291200.0);
    p = fma(z, p, 1.0 / 479001600.0);
    p = fma(z, p, -1.0 / 3628800.0);
    p = fma(z, p, 1.0 / 40320.0);
    p = fma(z, p, -1.0 / 720.0);
    p = fma(z, p, 1.0 / 24.0);
    p = fma(z, p, -0.5);
    return fma(z, p, 1.0);
}

// numeric.Angles
double seriesOfArc(double t) {
    double z = t * t;
    double p = fma(z, 1.0 / 21, -1.0 / 19);
    p = fma(z, p, 1.0 / 17);
    p = fma(z, p, -1.0 / 15);
    p = fma(z, p, 1.0 / 13);
    p = fma(z, p, -1.0 / 11);
    p = fma(z, p, 1.0 / 9);
    p = fma(z, p, -1.0 / 7);
    p = fma(z, p, 1.0 / 5);
    p = fma(z, p, -1.0 / 3);
    return fma(z * t, p, t);
}

#define PI 3.141592653589793

double arcOfTangent(double t) {
    if (t < 0.198912367379658) {
        return seriesOfArc(t);
    }
    if (t < 0.6681786379192989) {
        return PI / 8 + seriesOfArc((t - 0.41421356237309503) / fma(t, 0.41421356237309503, 1.0));
    }
    return PI / 4 + seriesOfArc((t - 1) / (t + 1));
}

double angleOf(double y, double x) {
    double ax = fabs(x);
    double ay = fabs(y);
    bool steep = ay > ax;
    double large = steep ? ay : ax;
    if (!(large > 0)) {
        return 0;
    }
    double angle = arcOfTangent((steep ? ax : ay) / large);
    if (steep) {
        angle = PI / 2 - angle;
    }
    if (x < 0) {
        angle = PI - angle;
    }
    return y < 0 ? -angle : angle;
}

// sampling.Hash
#define GOLDEN_GAMMA 0x9E3779B97F4A7C15UL

ulong mixed(ulong z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
    return z ^ (z >> 31);
}

ulong hashOf(ulong a, ulong b) {
    return mixed(mixed(a + GOLDEN_GAMMA) + b * GOLDEN_GAMMA + 1);
}

// sampling.Sobol
uint reversed(uint v) {
    v = (v >> 1 & 0x55555555u) | (v & 0x55555555u) << 1;
    v = (v >> 2 & 0x33333333u) | (v & 0x33333333u) << 2;
    v = (v >> 4 & 0x0F0F0F0Fu) | (v & 0x0F0F0F0Fu) << 4;
    v = (v >> 8 & 0x00FF00FFu) | (v & 0x00FF00FFu) << 8;
    return v >> 16 | v << 16;
}

uint scrambled(uint v, uint seed) {
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return reversed(v);
}

double sobolX(uint index, ulong seed) {
    return scrambled(index, (uint) seed) * 0x1p-32;
}

double sobolY(uint index, ulong seed) {
    uint v = index;
    v ^= (v & 0xAAAAAAAAu) >> 1;
    v ^= (v & 0xCCCCCCCCu) >> 2;
    v ^= (v & 0xF0F0F0F0u) >> 4;
    v ^= (v & 0xFF00FF00u) >> 8;
    v ^= (v & 0xFFFF0000u) >> 16;
    return scrambled(v, (uint) (seed >> 32)) * 0x1p-32;
}

uint shuffledIndex(uint index, ulong seed) {
    return scrambled(reversed(index), (uint) seed);
}

// sampling.Warp.toDisk: x, y and x² + y²
Vec toDisk(double u, double v) {
    double a = 2 * u - 1;
    double b = 2 * v - 1;
    bool swaps = signbit(fabs(a) - fabs(b));
    double r = swaps ? b : a;
    double phi = r == 0 ? 0 : PI / 4 * ((swaps ? a : b) / r);
    double p = r * cosineNearZero(phi);
    double q = r * sineNearZero(phi);
    return vec(swaps ? q : p, swaps ? p : q, r * r);
}

// numeric.Arcs, beyond small angles
#define HALF_PI (PI / 2)
#define HALF_PI_REST 6.123233995736766e-17
#define LEAST_ARC_COSINE (-0.5)

double restOfQuarters(double x, double quarters) {
    return fma(-quarters, HALF_PI_REST, fma(-quarters, HALF_PI, x));
}

double sineOf(double x) {
    double quarter = rint(x * (2 / PI));
    double rest = restOfQuarters(x, quarter);
    double s = ((int) quarter & 1) == 0 ? sineNearZero(rest) : cosineNearZero(rest);
    return ((int) quarter & 2) == 0 ? s : -s;
}

double cosineOf(double x) {
    double quarter = rint(x * (2 / PI));
    double rest = restOfQuarters(x, quarter);
    double c = ((int) quarter & 1) == 0 ? cosineNearZero(rest) : sineNearZero(rest);
    return (((int) quarter + 1) & 2) == 0 ? c : -c;
}

double arcOverSineNearOne(double t) {
    double z = t * t;
    double even = fma(z, -0.000132157752596636, 1.4743017805349805e-05);
    even = fma(z, even, 0.000539566898913318);
    even = fma(z, even, 0.002485954425869126);
    even = fma(z, even, 0.011544008764042558);
    even = fma(z, even, 0.05714285714079507);
    even = fma(z, even, 1.0 / 3);
    double odd = fma(z, 9.195087903114487e-05, 0.00023105799880840196);
    odd = fma(z, odd, 0.0003126151535212897);
    odd = fma(z, odd, 0.0011731553423059266);
    odd = fma(z, odd, 0.00532804927222027);
    odd = fma(z, odd, 0.02539682550179677);
    odd = fma(z, odd, 0.13333333333334924);
    return fma(t, fma(t, odd, even), 1);
}

double arcOverSine(double cosine) {
    if (cosine >= 0.5) {
        return arcOverSineNearOne(1 - cosine);
    }
    double halfCosine = sqrt(fma(0.5, cosine, 0.5));
    return arcOverSineNearOne(1 - halfCosine) / halfCosine;
}

// Metals: bsdf.Fresnel, Microfacets, AlbedoTable, SmoothConductor and GlossyReflection. Numbers of a metal: whether it is Schlick's, η, k and the
// mean reflectances by band; of a rough one then its facets, whether there is a table, and that.
#define SCHLICK 0
#define ETA 1
#define EXTINCTION 4
#define MEAN_REFLECTANCE 7
#define METAL_FACETS 10
#define METAL_HAS_TABLE 13
#define METAL_TABLE 14
#define LEAST_METAL_SHARE 0.1

// Facets: α, α², 1 − α².
#define ALPHA 0
#define ALPHA_SQUARED 1
#define FACETS_REST 2

// A table: mean loss, whether it is relative to that of a smooth coat, the part of even steps, α, the coat's index; then losses at 65 nodes,
// shares below the 65 edges of 64 cells, and densities in these.
#define MEAN_LOSS 0
#define RELATIVE_TO_SMOOTH 1
#define EVEN_STEPS 2
#define TABLE_ALPHA 3
#define TABLE_ETA 4
#define LOSSES 5
#define SHARES_BELOW 70
#define CELL_DENSITIES 135
#define TABLE_NODES 64
#define TABLE_CELLS 64

typedef struct {
    double density;
    double cosine;
} Facet;

// bsdf.DielectricFresnel
double refractedSquared(double c, double eta) {
    double etaCos = eta * c;
    return fma(etaCos, etaCos, (1 - eta) * (1 + eta));
}

double perpendicularReflectance(double c, double eta) {
    if (eta == 1) {
        return 0;
    }
    double through2 = refractedSquared(c, eta);
    if (!(through2 >= 0)) {
        return 1;
    }
    double sum = fma(eta, c, sqrt(through2));
    double r = (eta - 1) * (eta + 1) / (sum * sum);
    return smaller(r * r, 1);
}

double parallelRatio(double c, double eta) {
    double cosines = c * sqrt(refractedSquared(c, eta));
    double sines = eta * larger((1 - c) * (1 + c), 0);
    double sum = cosines + sines;
    double ratio = sum > 0 ? (cosines - sines) / sum : 1;
    return ratio * ratio;
}

double dielectricReflectance(double c, double eta) {
    double s = perpendicularReflectance(c, eta);
    return s < 1 ? 0.5 * (s + s * parallelRatio(c, eta)) : 1;
}

double conductorShare(double sum, double less) {
    return sum > 0 ? larger(sum - less, 0) / (sum + less) : 1;
}

double conductorReflectance(double c, double eta, double k) {
    double c2 = c * c;
    double s2 = larger((1 - c) * (1 + c), 0);
    double twice = 2 * eta * k;
    double t = (eta - k) * (eta + k) - s2;
    double sum = sqrt(fma(t, t, twice * twice));
    double a2 = t >= 0 ? 0.5 * (sum + t) : 0.5 * twice * twice / (sum - t);
    double ac = 2 * sqrt(a2) * c;
    double perpendicular = conductorShare(sum + c2, ac);
    double parallel = perpendicular * conductorShare(fma(c2, sum, s2 * s2), ac * s2);
    return 0.5 * (perpendicular + parallel);
}

Vec fresnelAt(__global const double *q, double c, Vec color) {
    if (q[SCHLICK] != 0) {
        double m = larger(1 - c, 0);
        double m2 = m * m;
        double w = m2 * m2 * m;
        return vec(fma(1 - color.x, w, color.x), fma(1 - color.y, w, color.y), fma(1 - color.z, w, color.z));
    }
    return vec(color.x * conductorReflectance(c, q[ETA], q[EXTINCTION]), color.y * conductorReflectance(c, q[ETA + 1], q[EXTINCTION + 1]),
            color.z * conductorReflectance(c, q[ETA + 2], q[EXTINCTION + 2]));
}

Vec meanReflectance(__global const double *q, Vec color) {
    if (q[SCHLICK] != 0) {
        return vec(color.x + (1 - color.x) / 21, color.y + (1 - color.y) / 21, color.z + (1 - color.z) / 21);
    }
    return vec(color.x * q[MEAN_REFLECTANCE], color.y * q[MEAN_REFLECTANCE + 1], color.z * q[MEAN_REFLECTANCE + 2]);
}

double reachOfFacets(__global const double *f, double cosine) {
    return sqrt(fma(f[FACETS_REST] * cosine, cosine, f[ALPHA_SQUARED]));
}

double maskingOf(__global const double *f, double in, double out) {
    return 1 / fma(out / in, reachOfFacets(f, in), reachOfFacets(f, out));
}

double visibleOf(__global const double *f, double out) {
    return 1 / (out + reachOfFacets(f, out));
}

// The facet that reflects one direction to the other.
Facet facetBetween(__global const double *f, const Scattering *s) {
    Vec h = vec(s->o.x + s->i.x, s->o.y + s->i.y, s->o.z + s->i.z);
    Vec n = s->n;
    double z = dotOf(h, n);
    double px = n.y * h.z - n.z * h.y;
    double py = n.z * h.x - n.x * h.z;
    double pz = n.x * h.y - n.y * h.x;
    double z2 = z * z;
    double p2 = px * px + py * py + pz * pz;
    double length2 = z2 + p2;
    double narrow = fma(f[ALPHA_SQUARED], z2, p2);
    Facet facet;
    facet.density = 0;
    facet.cosine = 0;
    if (z > 0 && narrow > 0) {
        double ratio = f[ALPHA] * (length2 / narrow);
        facet.density = ratio * ratio / PI;
        facet.cosine = smaller(larger(dotOf(h, s->o) / sqrt(length2), 0), 1);
    }
    return facet;
}

// Mirrors the way to the eye at a visible facet.
bool reflectAtFacet(__global const double *f, Scattering *s, double2 u) {
    Vec disk = toDisk(u.x, u.y);
    Vec a;
    Vec b;
    setBasis(s->n, &a, &b);
    double alpha = f[ALPHA];
    double x = alpha * dotOf(s->o, a);
    double y = alpha * dotOf(s->o, b);
    double z = larger(cosineOut(s), 0);
    double scale = 1 / sqrt(x * x + y * y + z * z);
    double k = fma(z, scale, 1);
    double q = sqrt(larger(k * (2 - disk.z * k), 0));
    double hx = alpha * fma(disk.x, q, x * scale);
    double hy = alpha * fma(disk.y, q, y * scale);
    double hz = k * larger(1 - disk.z, 0);
    if (!(hx * hx + hy * hy + hz * hz > 0)) {
        return false;
    }
    directLocal(s, hx, hy, hz);
    reflectFrom(s, s->i);
    return true;
}

double lossOf(__global const double *t, double cosine) {
    double steep = sqrt(cosine * (1 + t[TABLE_ALPHA]) / (cosine + t[TABLE_ALPHA]));
    double x = (TABLE_NODES - 1) * fma(t[EVEN_STEPS], cosine - steep, steep);
    int k = min((int) x, TABLE_NODES - 1);
    __global const double *nodes = t + LOSSES;
    double value = fma(x - k, nodes[k + 1] - nodes[k], nodes[k]);
    return t[RELATIVE_TO_SMOOTH] != 0 ? larger(1 - dielectricReflectance(cosine, t[TABLE_ETA]) * value, 0) : value;
}

double densityInTable(__global const double *t, double cosine) {
    return t[CELL_DENSITIES + min((int) (TABLE_CELLS * sqrt(cosine)), TABLE_CELLS - 1)] * cosine;
}

double multipleOf(__global const double *t, double mean) {
    return mean * mean * (1 - t[MEAN_LOSS]) / (1 - mean * t[MEAN_LOSS]);
}

double edgeSquared(int k) {
    double root = (double) k / TABLE_CELLS;
    return root * root * root * root;
}

void sampleTable(__global const double *t, Scattering *s, double2 u) {
    Vec disk = toDisk(u.x, u.y);
    double number = smaller(disk.z, 1);
    __global const double *below = t + SHARES_BELOW;
    int low = 0;
    int high = TABLE_CELLS;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (below[middle] <= number) {
            low = middle;
        } else {
            high = middle;
        }
    }
    double part = (number - below[low]) / (below[high] - below[low]);
    double from = edgeSquared(low);
    double z = sqrt(smaller(fma(part, edgeSquared(high) - from, from), 1));
    double across = disk.z > 0 ? sqrt((1 - z) * (1 + z) / disk.z) : 0;
    directLocal(s, disk.x * across, disk.y * across, z);
}

// The share of samples that leave a rough metal at their first facet.
double shareOfFirst(double first, double more, double lost) {
    double single = first * (1 - lost);
    double both = fma(more, lost, single);
    return both > 0 ? larger(single / both, LEAST_METAL_SHARE) : 1;
}

Vec multiplesOf(__global const double *t, Vec mean) {
    return vec(multipleOf(t, mean.x), multipleOf(t, mean.y), multipleOf(t, mean.z));
}

double shareOfMetal(const Scattering *s, double lost) {
    __global const double *t = s->q + METAL_TABLE;
    Vec mean = meanReflectance(s->q, s->color);
    Vec more = multiplesOf(t, mean);
    return shareOfFirst(mean.x + mean.y + mean.z, more.x + more.y + more.z, lost);
}

double mixedDensity(__global const double *t, double visible, double share, double in) {
    return fma(share, visible, (1 - share) * densityInTable(t, in));
}

double densityOfMetal(Scattering *s) {
    double in = cosineIn(s);
    if (!(in > 0)) {
        return 0;
    }
    double out = cosineOutClamped(s);
    __global const double *f = s->q + METAL_FACETS;
    double visible = 0.5 * facetBetween(f, s).density * visibleOf(f, out);
    __global const double *t = s->q + METAL_TABLE;
    return s->q[METAL_HAS_TABLE] == 0 ? visible : mixedDensity(t, visible, shareOfMetal(s, lossOf(t, out)), in);
}

void evaluateMetal(Scattering *s) {
    double in = cosineIn(s);
    if (!(in > 0)) {
        setNothing(s);
        return;
    }
    double out = cosineOutClamped(s);
    __global const double *f = s->q + METAL_FACETS;
    Facet facet = facetBetween(f, s);
    double single = 0.5 * facet.density * maskingOf(f, in, out);
    double visible = 0.5 * facet.density * visibleOf(f, out);
    Vec v = fresnelAt(s->q, facet.cosine, s->color);
    if (s->q[METAL_HAS_TABLE] == 0) {
        s->pdf = visible;
        s->value = vec(v.x * single, v.y * single, v.z * single);
        return;
    }
    __global const double *t = s->q + METAL_TABLE;
    double lost = lossOf(t, out);
    Vec m = multiplesOf(t, meanReflectance(s->q, s->color));
    s->pdf = mixedDensity(t, visible, shareOfMetal(s, lost), in);
    double more = lost * lossOf(t, in) * in / (PI * t[MEAN_LOSS]);
    s->value = vec(fma(v.x, single, m.x * more), fma(v.y, single, m.y * more), fma(v.z, single, m.z * more));
}

bool chooseOfMetal(Scattering *s, double2 u, double choice) {
    __global const double *t = s->q + METAL_TABLE;
    if (s->q[METAL_HAS_TABLE] != 0 && choice >= shareOfMetal(s, lossOf(t, cosineOutClamped(s)))) {
        sampleTable(t, s, u);
        return true;
    }
    return reflectAtFacet(s->q + METAL_FACETS, s, u);
}

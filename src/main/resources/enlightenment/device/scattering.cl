// A point of a surface and a direction that it scatters light to: bsdf.Scattering. Values of colours are f·|cosine|, over the density once a
// direction was sampled.
typedef struct {
    int kind;
    // The numbers of the material's kind.
    __global const double *q;
    // Whether the normal is interpolated: bsdf.SmoothShading of that kind.
    bool isSmooth;
    // Towards where the path came from and where it goes on; the shading normal, and the surface's own, on the side that the path came from.
    Vec o;
    Vec i;
    Vec n;
    Vec g;
    Vec color;
    // The index of refraction on this side over that of the other one.
    double eta;
    Vec value;
    double pdf;
    bool delta;
    bool transmitted;
} Scattering;

double dotOf(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

void directTo(Scattering *s, double x, double y, double z) {
    double scale = 1 / sqrt(x * x + y * y + z * z);
    s->i = vec(x * scale, y * scale, z * scale);
}

double cosineOut(const Scattering *s) {
    return dotOf(s->o, s->n);
}

double cosineIn(const Scattering *s) {
    return dotOf(s->i, s->n);
}

double cosineOutClamped(const Scattering *s) {
    return smaller(larger(cosineOut(s), 0), 1);
}

void setNothing(Scattering *s) {
    s->value = vec(0, 0, 0);
    s->pdf = 0;
}

void setOnly(Scattering *s, double probability, bool through) {
    s->pdf = probability;
    s->delta = true;
    s->transmitted = through;
}

// Sets what was sampled from value and density.
bool weigh(Scattering *s) {
    s->delta = false;
    double p = s->pdf;
    if (!(p > 0)) {
        return false;
    }
    s->value = vec(s->value.x / p, s->value.y / p, s->value.z / p);
    return true;
}

void reflectFrom(Scattering *s, Vec m) {
    double twice = 2 * dotOf(s->o, m);
    directTo(s, twice * m.x - s->o.x, twice * m.y - s->o.y, twice * m.z - s->o.z);
}

// A vector of the basis whose third vector is the normal.
Vec fromLocal(Vec n, double x, double y, double z) {
    Vec a;
    Vec b;
    setBasis(n, &a, &b);
    return vec(fma(x, a.x, fma(y, b.x, z * n.x)), fma(x, a.y, fma(y, b.y, z * n.y)), fma(x, a.z, fma(y, b.z, z * n.z)));
}

void directLocal(Scattering *s, double x, double y, double z) {
    Vec v = fromLocal(s->n, x, y, z);
    directTo(s, v.x, v.y, v.z);
}

void sampleCosine(Scattering *s, double2 u) {
    Vec disk = toDisk(u.x, u.y);
    directLocal(s, disk.x, disk.y, sqrt(larger(1 - disk.z, 0)));
}

// At a Lambertian surface: a unit vector up to rounding. The density may be 0.
void sampleMatte(Scattering *s, double2 u) {
    Vec disk = toDisk(u.x, u.y);
    double z = sqrt(larger(1 - disk.z, 0));
    s->i = fromLocal(s->n, disk.x, disk.y, z);
    s->pdf = z / PI;
    s->delta = false;
    s->transmitted = false;
}

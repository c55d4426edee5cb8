// How opaque surfaces scatter light: package bsdf. Values of colours are f·|cosine|, over the density once a direction was sampled.
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

double densityOfLambert(const Scattering *s) {
    return larger(cosineIn(s), 0) / PI;
}

double densityOfKind(Scattering *s) {
    switch (s->kind) {
        case MATTE:
            return densityOfLambert(s);
        default:
            return 0;
    }
}

void evaluateKind(Scattering *s) {
    switch (s->kind) {
        case MATTE: {
            double p = densityOfLambert(s);
            s->pdf = p;
            s->value = vec(s->color.x * p, s->color.y * p, s->color.z * p);
            break;
        }
        default:
            setNothing(s);
    }
}

bool sampleKind(Scattering *s, double2 u, double choice) {
    switch (s->kind) {
        case MATTE:
            sampleCosine(s, u);
            s->pdf = densityOfLambert(s);
            s->delta = false;
            s->transmitted = false;
            s->value = s->color;
            return s->pdf > 0;
        case MIRROR:
            reflectFrom(s, s->n);
            setOnly(s, 1, false);
            s->value = s->color;
            return true;
        default:
            return false;
    }
}

// bsdf.SmoothShading: turns the normal so that it is on the side of the eye.
void turnToEye(Scattering *s) {
    double cosine = dotOf(s->n, s->o);
    if (cosine < 0) {
        double twice = 2 * cosine;
        s->n = vec(s->n.x - twice * s->o.x, s->n.y - twice * s->o.y, s->n.z - twice * s->o.z);
    }
}

void softenTerminator(Scattering *s, double in) {
    double own = dotOf(s->i, s->g);
    double between = fabs(s->n.x * s->g.x + s->n.y * s->g.y + s->n.z * s->g.z);
    double g = smaller(own / (in * between), 1);
    double f = g * fma(g, 1 - g, 1);
    s->value = vec(s->value.x * f, s->value.y * f, s->value.z * f);
}

bool isBehindSurface(const Scattering *s) {
    return !(dotOf(s->i, s->g) > 0) || !(dotOf(s->o, s->g) > 0);
}

void evaluateSmooth(Scattering *s) {
    if (isBehindSurface(s)) {
        setNothing(s);
        return;
    }
    Vec n = s->n;
    turnToEye(s);
    double in = cosineIn(s);
    if (in > 0 && cosineOut(s) > 0) {
        evaluateKind(s);
        softenTerminator(s, in);
    } else {
        setNothing(s);
    }
    s->n = n;
}

double densityOf(Scattering *s) {
    if (!s->isSmooth) {
        return densityOfKind(s);
    }
    if (isBehindSurface(s)) {
        return 0;
    }
    Vec n = s->n;
    turnToEye(s);
    double p = densityOfKind(s);
    s->n = n;
    return p;
}

void evaluate(Scattering *s) {
    if (!s->isSmooth) {
        evaluateKind(s);
        return;
    }
    double p = densityOf(s);
    evaluateSmooth(s);
    s->pdf = p;
}

bool sampleSmooth(Scattering *s, double2 u, double choice) {
    Vec n = s->n;
    turnToEye(s);
    bool goes = sampleKind(s, u, choice) && dotOf(s->i, s->g) > 0 && dotOf(s->o, s->g) > 0 && cosineIn(s) > 0 && cosineOut(s) > 0;
    if (goes && s->delta) {
        softenTerminator(s, cosineIn(s));
    }
    s->n = n;
    if (!goes) {
        setNothing(s);
        return false;
    }
    if (s->delta) {
        return true;
    }
    double p = s->pdf;
    evaluateSmooth(s);
    s->pdf = p;
    return weigh(s);
}

bool sampleBsdf(Scattering *s, double2 u, double choice) {
    return s->isSmooth ? sampleSmooth(s, u, choice) : sampleKind(s, u, choice);
}

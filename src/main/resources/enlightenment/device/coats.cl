// Clear coats on matte surfaces, and rough matte ones: bsdf.CoatedBase, SmoothCoating, RoughCoating and RoughDiffuse. Numbers of a coat: 1 over its
// index, the scale of the base, what of that light is reflected inside, and whether that colours it more; of a rough one then facets and table.
#define COAT_ETA 0
#define BASE_SCALE 1
#define REFLECTED_INSIDE 2
#define NONLINEAR 3
#define COAT_FACETS 4
#define COAT_TABLE 7

double reflectedOfBase(__global const double *q, double color) {
    double inside = q[REFLECTED_INSIDE];
    return q[NONLINEAR] != 0 ? color * (1 - inside) / (1 - color * inside) : color;
}

double reflectedThrough(const Scattering *s, double through) {
    return through * (reflectedOfBase(s->q, s->color.x) + reflectedOfBase(s->q, s->color.y) + reflectedOfBase(s->q, s->color.z)) / 3;
}

void setCoated(Scattering *s, double diffuse, double coat) {
    s->value = vec(fma(reflectedOfBase(s->q, s->color.x), diffuse, coat), fma(reflectedOfBase(s->q, s->color.y), diffuse, coat),
            fma(reflectedOfBase(s->q, s->color.z), diffuse, coat));
}

double transmittanceOfCoat(double cosine, double eta) {
    double through = sqrt(refractedSquared(cosine, eta));
    double perpendicular = 1 / fma(eta, cosine, through);
    double parallel = 1 / fma(eta, through, cosine);
    double s = cosine * perpendicular * (through * perpendicular);
    double p = cosine * parallel * (through * parallel);
    return smaller(2 * eta * (s + p), 1);
}

double shareOfCoatItself(const Scattering *s, double through) {
    double coat = 1 - through;
    double base = reflectedThrough(s, through);
    if (!(coat > 0)) {
        return 0;
    }
    return coat < base ? sqrt(coat) / (sqrt(coat) + sqrt(base)) : coat / (coat + base);
}

double densityOfCoat(Scattering *s) {
    double in = cosineIn(s);
    return in > 0 ? (1 - shareOfCoatItself(s, transmittanceOfCoat(cosineOutClamped(s), s->q[COAT_ETA]))) * in / PI : 0;
}

void evaluateCoat(Scattering *s) {
    double in = cosineIn(s);
    if (!(in > 0)) {
        setNothing(s);
        return;
    }
    double eta = s->q[COAT_ETA];
    double through = transmittanceOfCoat(cosineOutClamped(s), eta);
    double diffuse = through * transmittanceOfCoat(smaller(in, 1), eta) * in * s->q[BASE_SCALE];
    s->pdf = (1 - shareOfCoatItself(s, through)) * in / PI;
    setCoated(s, diffuse, 0);
}

// Samples the mirror image in the coat, if the choice falls on that.
bool sampleCoatItself(Scattering *s, double choice) {
    double through = transmittanceOfCoat(cosineOutClamped(s), s->q[COAT_ETA]);
    double share = shareOfCoatItself(s, through);
    if (!(choice < share)) {
        return false;
    }
    reflectFrom(s, s->n);
    setOnly(s, share, false);
    double weight = (1 - through) / share;
    s->value = vec(weight, weight, weight);
    return true;
}

double shareOfRoughCoat(const Scattering *s, double entering) {
    double coat = 1 - entering;
    return coat > 0 ? coat / (coat + reflectedThrough(s, entering)) : 0;
}

double mixedDensityOfCoat(const Scattering *s, double facets, double in, double out, double entering) {
    double share = shareOfRoughCoat(s, entering);
    return fma(share, 0.5 * facets * visibleOf(s->q + COAT_FACETS, out), (1 - share) * densityInTable(s->q + COAT_TABLE, smaller(in, 1)));
}

double densityOfRoughCoat(Scattering *s) {
    double in = cosineIn(s);
    if (!(in > 0)) {
        return 0;
    }
    double out = cosineOutClamped(s);
    return mixedDensityOfCoat(s, facetBetween(s->q + COAT_FACETS, s).density, in, out, lossOf(s->q + COAT_TABLE, out));
}

void evaluateRoughCoat(Scattering *s) {
    double in = cosineIn(s);
    if (!(in > 0)) {
        setNothing(s);
        return;
    }
    double out = cosineOutClamped(s);
    __global const double *f = s->q + COAT_FACETS;
    __global const double *t = s->q + COAT_TABLE;
    double entering = lossOf(t, out);
    Facet facet = facetBetween(f, s);
    double coat = 0.5 * facet.density * maskingOf(f, in, out) * dielectricReflectance(facet.cosine, s->q[COAT_ETA]);
    s->pdf = mixedDensityOfCoat(s, facet.density, in, out, entering);
    setCoated(s, entering * lossOf(t, smaller(in, 1)) * in * s->q[BASE_SCALE], coat);
}

bool chooseOfRoughCoat(Scattering *s, double2 u, double choice) {
    __global const double *t = s->q + COAT_TABLE;
    if (choice >= shareOfRoughCoat(s, lossOf(t, cosineOutClamped(s)))) {
        sampleTable(t, s, u);
        return true;
    }
    return reflectAtFacet(s->q + COAT_FACETS, s, u);
}

// Numbers of a rough matte surface: roughness, scale, mean albedo, scale of what is scattered more than once, and c1.
#define MATTE_ROUGHNESS 0
#define MATTE_SCALE 1
#define MATTE_MEAN 2
#define MATTE_MULTIPLE 3
#define MATTE_C1 4

double evenShare(const Scattering *s, double out) {
    return 0.5 * s->q[MATTE_ROUGHNESS] * (1 - out) * (1 - out);
}

double mixedDensityOfMatte(const Scattering *s, double in, double out) {
    return fma(evenShare(s, out), 0.5 - in, in) / PI;
}

double densityOfRoughMatte(Scattering *s) {
    double in = cosineIn(s);
    return in > 0 ? mixedDensityOfMatte(s, in, cosineOutClamped(s)) : 0;
}

double lostByMatte(const Scattering *s, double cosine) {
    double c = smaller(cosine, 1);
    double m = sqrt(1 - c);
    double sine = m * sqrt(1 + c);
    double p = fma(c, -0.0012624911, 0.0066700901);
    p = fma(c, p, -0.0170881256);
    p = fma(c, p, 0.0308918810);
    p = fma(c, p, -0.0501743046);
    p = fma(c, p, 0.0889789874);
    p = fma(c, p, -0.2145988016);
    double arc = fma(c, p, 1.5707963050);
    double g = sine * (m * arc - sine * c + 2 / 3.0 * (c * (1 + sine + sine * sine) / (1 + sine) - 1));
    return larger(s->q[MATTE_C1] - g / PI, 0);
}

double valueOfRoughMatte(const Scattering *s, double color, double single, double more) {
    double mean = s->q[MATTE_MEAN];
    return color * fma(color * mean / (1 - color * (1 - mean)), more, single);
}

void evaluateRoughMatte(Scattering *s) {
    double in = cosineIn(s);
    if (!(in > 0)) {
        setNothing(s);
        return;
    }
    double out = cosineOutClamped(s);
    s->pdf = mixedDensityOfMatte(s, in, out);
    double cosine = dotOf(s->o, s->i) - in * out;
    double retro = cosine > 0 ? cosine * (in / larger(in, out)) : cosine * in;
    double single = s->q[MATTE_SCALE] * larger(fma(s->q[MATTE_ROUGHNESS], retro, in), 0);
    double more = s->q[MATTE_MULTIPLE] * lostByMatte(s, out) * lostByMatte(s, in) * in;
    s->value = vec(valueOfRoughMatte(s, s->color.x, single, more), valueOfRoughMatte(s, s->color.y, single, more),
            valueOfRoughMatte(s, s->color.z, single, more));
}

bool chooseOfRoughMatte(Scattering *s, double2 u, double choice) {
    if (!(choice < evenShare(s, cosineOutClamped(s)))) {
        sampleCosine(s, u);
        return true;
    }
    Vec disk = toDisk(u.x, u.y);
    double across = sqrt(2 - disk.z);
    directLocal(s, disk.x * across, disk.y * across, 1 - disk.z);
    return true;
}

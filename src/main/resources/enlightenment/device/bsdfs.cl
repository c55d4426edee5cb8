// How opaque surfaces scatter light, by kind: package bsdf.
double densityOfLambert(const Scattering *s) {
    return larger(cosineIn(s), 0) / PI;
}

double densityOfKind(Scattering *s) {
    switch (s->kind) {
        case MATTE:
            return densityOfLambert(s);
        case ROUGH_MATTE:
            return densityOfRoughMatte(s);
        case ROUGH_METAL:
            return densityOfMetal(s);
        case COAT:
            return densityOfCoat(s);
        case ROUGH_COAT:
            return densityOfRoughCoat(s);
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
        case ROUGH_MATTE:
            evaluateRoughMatte(s);
            break;
        case ROUGH_METAL:
            evaluateMetal(s);
            break;
        case COAT:
            evaluateCoat(s);
            break;
        case ROUGH_COAT:
            evaluateRoughCoat(s);
            break;
        default:
            setNothing(s);
    }
}

// Samples a lobe that is a single direction; whether there is one.
bool sampleSingle(Scattering *s, double choice) {
    if (s->kind == MIRROR) {
        reflectFrom(s, s->n);
        setOnly(s, 1, false);
        s->value = s->color;
        return true;
    }
    if (s->kind == METAL) {
        reflectFrom(s, s->n);
        setOnly(s, 1, false);
        s->value = fresnelAt(s->q, cosineOutClamped(s), s->color);
        return true;
    }
    return s->kind == COAT && sampleCoatItself(s, choice);
}

// Chooses a direction of the other lobes.
bool chooseDirection(Scattering *s, double2 u, double choice) {
    switch (s->kind) {
        case ROUGH_MATTE:
            return chooseOfRoughMatte(s, u, choice);
        case ROUGH_METAL:
            return chooseOfMetal(s, u, choice);
        case ROUGH_COAT:
            return chooseOfRoughCoat(s, u, choice);
        default:
            sampleCosine(s, u);
            return true;
    }
}

bool sampleKind(Scattering *s, double2 u, double choice) {
    if (sampleSingle(s, choice)) {
        return true;
    }
    s->transmitted = false;
    s->delta = false;
    if (!chooseDirection(s, u, choice)) {
        return false;
    }
    evaluateKind(s);
    if (s->kind == MATTE) {
        s->value = s->color;
        return s->pdf > 0;
    }
    return weigh(s);
}

// A border of glass: bsdf.SmoothDielectric, and SmoothRefraction where normals are those of vertices.
bool sampleBorder(Scattering *s, double choice) {
    bool isSmooth = s->kind == SMOOTH_GLASS;
    if (isSmooth && !(cosineOut(s) > 0)) {
        return false;
    }
    double c = cosineOutClamped(s);
    double share = dielectricReflectance(c, s->eta);
    double cosine2 = refractedSquared(c, s->eta);
    bool through = choice >= share && cosine2 >= 0;
    if (through) {
        double along = s->eta * c - sqrt(cosine2);
        directTo(s, fma(along, s->n.x, -s->eta * s->o.x), fma(along, s->n.y, -s->eta * s->o.y), fma(along, s->n.z, -s->eta * s->o.z));
        setOnly(s, 1 - share, true);
    } else {
        reflectFrom(s, s->n);
        setOnly(s, share, false);
    }
    s->value = vec(1, 1, 1);
    double side = through ? -1 : 1;
    return s->pdf > 0 && (!isSmooth || side * dotOf(s->i, s->g) > 0 && side * cosineIn(s) > 0);
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

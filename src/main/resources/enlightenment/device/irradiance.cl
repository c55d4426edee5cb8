// Closed forms of irradiance for radiance 1: emitter.SphereIrradiance, LambertRectangle and HorizonPolygon.
#define SPHERE_TERMS 26

double sphereExcess(double z) {
    double q = z * z;
    double sum = 0;
    for (int n = 27; n >= 3; n -= 2) {
        sum = fma(-q, sum, 1.0 / n);
    }
    return q * sum;
}

double littleOfSphere(double s, double c, double p) {
    double q = p * p;
    double square = s * s;
    double sum = 0;
    double term = 2.0 / 15;
    double powers = 1;
    for (int j = 0; j < SPHERE_TERMS; j++) {
        sum = fma(term, powers, sum);
        term *= q * ((2 * j + 4.0) / (2 * j + 7.0));
        powers = fma(powers, square, 1);
    }
    return s * square * c * q * q * p * sum;
}

// The ball is cut by the horizon: |k| < s.
double cutSphere(double s, double c, double k) {
    double t = sqrt((s - k) * (s + k));
    double across = sqrt((1 - k) * (1 + k));
    double p = t / (s * across);
    if (k < 0 && p < 0.5) {
        return littleOfSphere(s, c, p) * across;
    }
    double slice = s * s * k * angleOf(t, -c * k);
    if (t < 0.25 * c) {
        double z = t / c;
        return slice + z * (s * s - sphereExcess(z));
    }
    return slice + (angleOf(t, c) - c * t);
}

double irradianceOfSphere(const Cone *cone, Vec n) {
    double k = n.x * cone->w.x + n.y * cone->w.y + n.z * cone->w.z;
    double s = cone->sine;
    if (k >= s) {
        return PI * k * s * s;
    }
    return k <= -s ? 0 : cutSphere(s, cone->cosine, k);
}

// NaN if the horizon cuts the rectangle, or an edge covers more than 120°.
double irradianceOfWhole(double x, double width, double y, double length, double z, double nx, double ny, double nz) {
    double right = x + width;
    double high = y + length;
    if (!(smaller(nx * x, nx * right) + smaller(ny * y, ny * high) + nz * z >= 0)) {
        return NAN;
    }
    double zz = z * z;
    double low2 = fma(y, y, zz);
    double high2 = fma(high, high, zz);
    double xx = x * x;
    double rr = right * right;
    double a = sqrt(xx + low2);
    double b = sqrt(rr + low2);
    double c = sqrt(rr + high2);
    double d = sqrt(xx + high2);
    double ab = a * b;
    double cd = c * d;
    double inverse = 1 / (ab * cd);
    double overAb = cd * inverse;
    double overCd = ab * inverse;
    double overBc = a * d * inverse;
    double overDa = b * c * inverse;
    double across = x * right;
    double up = fma(y, high, zz);
    double cosAb = (across + low2) * overAb;
    double cosCd = (across + high2) * overCd;
    double cosBc = (rr + up) * overBc;
    double cosDa = (xx + up) * overDa;
    if (!(smaller(smaller(cosAb, cosCd), smaller(cosBc, cosDa)) >= LEAST_ARC_COSINE)) {
        return NAN;
    }
    double alongFirst = fma(ny, z, -nz * y) * overAb * arcOverSine(cosAb) - fma(ny, z, -nz * high) * overCd * arcOverSine(cosCd);
    double alongSecond = fma(nx, z, -nz * x) * overDa * arcOverSine(cosDa) - fma(nx, z, -nz * right) * overBc * arcOverSine(cosBc);
    return smaller(0.5 * fabs(fma(width, alongFirst, length * alongSecond)), PI);
}

#define MOST_CORNERS 6
#define NEAR_CENTRE ((6 + sqrt(15.0)) / 21)
#define NEAR_CORNER ((6 - sqrt(15.0)) / 21)
#define CENTROID_WEIGHT (9.0 / 40)
#define CENTRE_WEIGHT ((155 + sqrt(15.0)) / 1200)
#define CORNER_WEIGHT ((155 - sqrt(15.0)) / 1200)

typedef struct {
    // What is above the horizon of the receiver with the normal n, from the first corner, which is at base.
    Vec corner[MOST_CORNERS];
    int count;
    Vec base;
    Vec n;
} Polygon;

// The corners are the base and those at these offsets from it.
void clipParallelogram(Polygon *p, Vec right, Vec up) {
    Vec raw[4];
    raw[0] = vec(0, 0, 0);
    raw[1] = right;
    raw[2] = vec(right.x + up.x, right.y + up.y, right.z + up.z);
    raw[3] = up;
    Vec n = p->n;
    p->count = 0;
    int last = 3;
    double base = n.x * p->base.x + n.y * p->base.y + n.z * p->base.z;
    double before = base + (n.x * raw[last].x + n.y * raw[last].y + n.z * raw[last].z);
    for (int k = 0; k < 4; k++) {
        double here = base + (n.x * raw[k].x + n.y * raw[k].y + n.z * raw[k].z);
        if (here > 0 && before < 0 || here < 0 && before > 0) {
            double share = before / (before - here);
            p->corner[p->count++] = vec(fma(share, raw[k].x - raw[last].x, raw[last].x), fma(share, raw[k].y - raw[last].y, raw[last].y),
                    fma(share, raw[k].z - raw[last].z, raw[last].z));
        }
        if (here >= 0) {
            p->corner[p->count++] = raw[k];
        }
        last = k;
        before = here;
    }
}

double sumOverEdges(const Polygon *p) {
    double sum = 0;
    Vec l = p->corner[p->count - 1];
    Vec a = vec(p->base.x + l.x, p->base.y + l.y, p->base.z + l.z);
    for (int k = 0; k < p->count; k++) {
        Vec c = p->corner[k];
        Vec b = vec(p->base.x + c.x, p->base.y + c.y, p->base.z + c.z);
        double cx = a.y * b.z - a.z * b.y;
        double cy = a.z * b.x - a.x * b.z;
        double cz = a.x * b.y - a.y * b.x;
        double length = sqrt(cx * cx + cy * cy + cz * cz);
        if (length > 0) {
            double angle = angleOf(length, a.x * b.x + a.y * b.y + a.z * b.z);
            sum += angle * ((p->n.x * cx + p->n.y * cy + p->n.z * cz) / length);
        }
        a = b;
    }
    return 0.5 * fabs(sum);
}

double atPolygon(const Polygon *s, int k, double p, double q) {
    double o = 1 - p - q;
    double px = s->base.x + o * s->corner[0].x + p * s->corner[k].x + q * s->corner[k + 1].x;
    double py = s->base.y + o * s->corner[0].y + p * s->corner[k].y + q * s->corner[k + 1].y;
    double pz = s->base.z + o * s->corner[0].z + p * s->corner[k].z + q * s->corner[k + 1].z;
    double square = px * px + py * py + pz * pz;
    return larger(s->n.x * px + s->n.y * py + s->n.z * pz, 0) / (square * square);
}

double overTriangle(const Polygon *s, int k) {
    Vec o = s->corner[0];
    double ax = s->corner[k].x - o.x;
    double ay = s->corner[k].y - o.y;
    double az = s->corner[k].z - o.z;
    double bx = s->corner[k + 1].x - o.x;
    double by = s->corner[k + 1].y - o.y;
    double bz = s->corner[k + 1].z - o.z;
    double cx = ay * bz - az * by;
    double cy = az * bx - ax * bz;
    double cz = ax * by - ay * bx;
    double near = 1 - 2 * NEAR_CENTRE;
    double corner = 1 - 2 * NEAR_CORNER;
    double sum = CENTROID_WEIGHT * atPolygon(s, k, 1.0 / 3, 1.0 / 3)
            + CENTRE_WEIGHT * (atPolygon(s, k, NEAR_CENTRE, NEAR_CENTRE) + atPolygon(s, k, near, NEAR_CENTRE) + atPolygon(s, k, NEAR_CENTRE, near))
            + CORNER_WEIGHT
                    * (atPolygon(s, k, NEAR_CORNER, NEAR_CORNER) + atPolygon(s, k, corner, NEAR_CORNER) + atPolygon(s, k, NEAR_CORNER, corner));
    return 0.5 * sqrt(cx * cx + cy * cy + cz * cz) * sum;
}

double irradianceOfParallelogram(Vec base, Vec right, Vec up, Vec n, double height, bool far) {
    Polygon p;
    p.base = base;
    p.n = n;
    clipParallelogram(&p, right, up);
    if (p.count < 3) {
        return 0;
    }
    if (!far) {
        return smaller(sumOverEdges(&p), PI);
    }
    double sum = 0;
    for (int k = 1; k + 1 < p.count; k++) {
        sum += overTriangle(&p, k);
    }
    return sum * height;
}

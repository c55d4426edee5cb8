// Lights as they are seen from a point: frame.BallCone, frame.Basis, emitter.SphereEmitter, RectangleEmitter and PointEmitter. Numbers of a
// light: colour, centre and radius of the ball around it; then corner, right and up of a rectangle.
#define LIGHT_SIZE 4
#define LIGHT_KIND 0
#define LIGHT_SURFACE 1
#define LIGHT_NUMBERS 2
#define LIGHT_HIERARCHY 3

typedef struct {
    __global const double *q;
    int kind;
    // The apex, the direction to the centre of the ball, and its distance.
    Vec at;
    Vec w;
    double distance;
    double radius;
    double sine;
    double cosine;
    bool inside;
    // Two unit vectors across w.
    Vec a;
    Vec b;
    // The normal in that basis.
    double normalAlong;
    double normalAcross;
    double normalA;
    double normalB;
    // The last point that was sampled: direction and distance.
    Vec d;
    double length;
} View;

__global const int *lightOf(const Scene *s, int index) {
    return s->i + s->i[LIGHTS] + LIGHT_SIZE * index;
}

void aim(const Scene *s, View *v, int index, Vec p) {
    __global const int *light = lightOf(s, index);
    __global const double *q = s->d + light[LIGHT_NUMBERS];
    v->kind = light[LIGHT_KIND];
    v->q = q;
    double dx = q[3] - p.x;
    double dy = q[4] - p.y;
    double dz = q[5] - p.z;
    double d = sqrt(dx * dx + dy * dy + dz * dz);
    double inverse = d == 0 ? 0 : 1 / d;
    v->at = p;
    v->radius = q[6];
    v->distance = d;
    v->w = vec(dx * inverse, dy * inverse, dz * inverse);
    v->inside = !(d > v->radius);
    if (!v->inside) {
        v->sine = v->radius * inverse;
        v->cosine = sqrt((d - v->radius) * (d + v->radius)) * inverse;
    }
    double sign = copysign(1.0, v->w.z);
    double m = -1 / (sign + v->w.z);
    double n = v->w.x * v->w.y * m;
    v->a = vec(1 + sign * v->w.x * v->w.x * m, sign * n, -sign * v->w.x);
    v->b = vec(n, sign + v->w.y * v->w.y * m, -v->w.y);
}

double oneMinusCosine(const View *v) {
    return v->sine * v->sine / (1 + v->cosine);
}

// The mean cosine between a normal and the directions to the light; NaN where there is no closed form.
double meanCosine(const View *v, Vec n) {
    double toCenter = n.x * v->w.x + n.y * v->w.y + n.z * v->w.z;
    if (v->kind == POINT_LIGHT) {
        return larger(toCenter, 0);
    }
    if (v->kind == RECTANGLE_LIGHT) {
        __global const double *q = v->q + 7;
        double there = n.x * (q[0] - v->at.x) + n.y * (q[1] - v->at.y) + n.z * (q[2] - v->at.z);
        double toRight = n.x * q[3] + n.y * q[4] + n.z * q[5];
        double toTop = n.x * q[6] + n.y * q[7] + n.z * q[8];
        return there + larger(toRight, 0) + larger(toTop, 0) <= 0 ? 0 : NAN;
    }
    if (v->inside) {
        return NAN;
    }
    if (toCenter >= v->sine) {
        return toCenter * (1 - oneMinusCosine(v) / 2);
    }
    return toCenter <= -v->sine ? 0 : NAN;
}

void setOffset(View *v, double cosine, double s, double t, double sin2) {
    double half2 = v->radius * v->radius - v->distance * v->distance * sin2;
    double halfOf = half2 > 0 ? sqrt(half2) : 0;
    v->d = vec(fma(cosine, v->w.x, fma(s, v->a.x, t * v->b.x)), fma(cosine, v->w.y, fma(s, v->a.y, t * v->b.y)),
            fma(cosine, v->w.z, fma(s, v->a.z, t * v->b.z)));
    v->length = v->distance * cosine - halfOf;
}

void sampleLight(View *v, double x, double y) {
    if (v->kind == POINT_LIGHT) {
        v->d = v->w;
        v->length = v->distance;
        return;
    }
    if (v->kind == RECTANGLE_LIGHT) {
        __global const double *q = v->q + 7;
        double px = fma(x, q[3], fma(y, q[6], q[0] - v->at.x));
        double py = fma(x, q[4], fma(y, q[7], q[1] - v->at.y));
        double pz = fma(x, q[5], fma(y, q[8], q[2] - v->at.z));
        double length = sqrt(px * px + py * py + pz * pz);
        double inverse = length == 0 ? 0 : 1 / length;
        v->d = vec(px * inverse, py * inverse, pz * inverse);
        v->length = length;
        return;
    }
    Vec disk = toDisk(x, y);
    if (v->inside) {
        double spread = 2 * sqrt(larger(1 - disk.z, 0));
        double px = disk.x * spread;
        double py = disk.y * spread;
        double pz = 1 - 2 * disk.z;
        double along = (px * v->w.x + py * v->w.y + pz * v->w.z) * v->distance;
        double halfOf = sqrt(larger(v->radius * v->radius - v->distance * v->distance + along * along, 0));
        v->d = vec(px, py, pz);
        v->length = along + halfOf;
        return;
    }
    double down = disk.z * oneMinusCosine(v);
    double spread = sqrt(oneMinusCosine(v) * (2 - down));
    setOffset(v, 1 - down, disk.x * spread, disk.y * spread, down * (2 - down));
}

void prepareByCosine(View *v, Vec n) {
    if (v->kind != BALL_LIGHT) {
        return;
    }
    double na = n.x * v->a.x + n.y * v->a.y + n.z * v->a.z;
    double nb = n.x * v->b.x + n.y * v->b.y + n.z * v->b.z;
    v->normalAlong = n.x * v->w.x + n.y * v->w.y + n.z * v->w.z;
    v->normalAcross = sqrt(na * na + nb * nb);
    v->normalA = v->normalAcross > 0 ? na / v->normalAcross : 1;
    v->normalB = v->normalAcross > 0 ? nb / v->normalAcross : 0;
}

void sampleByCosine(View *v, double x, double y) {
    if (v->kind != BALL_LIGHT) {
        sampleLight(v, x, y);
        return;
    }
    Vec disk = toDisk(x, y);
    double a = v->normalAlong * disk.x;
    double least = v->normalAlong * v->cosine;
    double excess = v->sine * fma(2 * v->cosine * v->normalAcross, a, v->sine * (1 - a * a - disk.y * disk.y));
    double square = least * least + excess;
    double sum = square > 0 ? least + sqrt(square) : least;
    double delta = sum > 0 ? excess / sum : 0;
    double p = fma(v->normalAcross, delta, v->sine * v->normalAlong * a);
    double q = v->sine * disk.y;
    double middle = fma(v->cosine, v->normalAcross, -v->sine * a);
    double along = fma(middle, v->normalAcross, (least + delta) * v->normalAlong);
    double s = p * v->normalA - q * v->normalB;
    double t = p * v->normalB + q * v->normalA;
    setOffset(v, along, s, t, s * s + t * t);
}

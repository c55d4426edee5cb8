// Lights as they are seen from a point: emitter.SphereEmitter, RectangleEmitter and PointEmitter. A light among the integers: what it is, the
// primitive that is seen of it (or -1), where its numbers are, and the hierarchy that is searched for what is in the way; in physical shading
// also the face, the sides that shine, where the primitives are that may occlude it and how many (or -1: all may), its pyramid (or -1),
// whether its primitive hides none of it, whether rays end on that face, and whether the caustic pass takes its light from narrow lobes.
// Numbers of a light: colour, centre and radius of the ball around it; then corner, right and up of a rectangle; in physical shading also the
// two edges as unit vectors, normal, width, length and area, and the tolerance of a face that rays end on.
#define LIGHT_SIZE 12
#define LIGHT_KIND 0
#define LIGHT_SURFACE 1
#define LIGHT_NUMBERS 2
#define LIGHT_HIERARCHY 3
#define LIGHT_FACE 4
#define LIGHT_SIDES 5
#define OCCLUDERS 6
#define OCCLUDER_COUNT 7
#define PYRAMID 8
#define HIDES_NOTHING 9
#define ENDS_ON_FACE 10
#define TAKES_NARROW 11

typedef struct {
    __global const double *q;
    int kind;
    // Around its ball.
    Cone cone;
    // Two unit vectors across the cone's axis.
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
    setCone(&v->cone, q[3], q[4], q[5], q[6], p);
    if (v->kind == BALL_LIGHT) {
        setBasis(v->cone.w, &v->a, &v->b);
    }
}

// The mean cosine between a normal and the directions to the light; NaN where there is no closed form.
double meanCosine(const View *v, Vec n) {
    double toCenter = n.x * v->cone.w.x + n.y * v->cone.w.y + n.z * v->cone.w.z;
    if (v->kind == POINT_LIGHT) {
        return larger(toCenter, 0);
    }
    if (v->kind == RECTANGLE_LIGHT) {
        __global const double *q = v->q + 7;
        double there = n.x * (q[0] - v->cone.at.x) + n.y * (q[1] - v->cone.at.y) + n.z * (q[2] - v->cone.at.z);
        double toRight = n.x * q[3] + n.y * q[4] + n.z * q[5];
        double toTop = n.x * q[6] + n.y * q[7] + n.z * q[8];
        return there + larger(toRight, 0) + larger(toTop, 0) <= 0 ? 0 : NAN;
    }
    if (v->cone.inside) {
        return NAN;
    }
    if (toCenter >= v->cone.sine) {
        return toCenter * (1 - oneMinusCosine(&v->cone) / 2);
    }
    return toCenter <= -v->cone.sine ? 0 : NAN;
}

void setOffset(View *v, double cosine, double s, double t, double sin2) {
    double half2 = v->cone.radius * v->cone.radius - v->cone.distance * v->cone.distance * sin2;
    double halfOf = half2 > 0 ? sqrt(half2) : 0;
    v->d = vec(fma(cosine, v->cone.w.x, fma(s, v->a.x, t * v->b.x)), fma(cosine, v->cone.w.y, fma(s, v->a.y, t * v->b.y)),
            fma(cosine, v->cone.w.z, fma(s, v->a.z, t * v->b.z)));
    v->length = v->cone.distance * cosine - halfOf;
}

void sampleLight(View *v, double x, double y) {
    if (v->kind == POINT_LIGHT) {
        v->d = v->cone.w;
        v->length = v->cone.distance;
        return;
    }
    if (v->kind == RECTANGLE_LIGHT) {
        __global const double *q = v->q + 7;
        double px = fma(x, q[3], fma(y, q[6], q[0] - v->cone.at.x));
        double py = fma(x, q[4], fma(y, q[7], q[1] - v->cone.at.y));
        double pz = fma(x, q[5], fma(y, q[8], q[2] - v->cone.at.z));
        double length = sqrt(px * px + py * py + pz * pz);
        double inverse = length == 0 ? 0 : 1 / length;
        v->d = vec(px * inverse, py * inverse, pz * inverse);
        v->length = length;
        return;
    }
    Vec disk = toDisk(x, y);
    if (v->cone.inside) {
        double spread = 2 * sqrt(larger(1 - disk.z, 0));
        double px = disk.x * spread;
        double py = disk.y * spread;
        double pz = 1 - 2 * disk.z;
        double along = (px * v->cone.w.x + py * v->cone.w.y + pz * v->cone.w.z) * v->cone.distance;
        double halfOf = sqrt(larger(v->cone.radius * v->cone.radius - v->cone.distance * v->cone.distance + along * along, 0));
        v->d = vec(px, py, pz);
        v->length = along + halfOf;
        return;
    }
    double down = disk.z * oneMinusCosine(&v->cone);
    double spread = sqrt(oneMinusCosine(&v->cone) * (2 - down));
    setOffset(v, 1 - down, disk.x * spread, disk.y * spread, down * (2 - down));
}

void prepareByCosine(View *v, Vec n) {
    if (v->kind != BALL_LIGHT) {
        return;
    }
    double na = n.x * v->a.x + n.y * v->a.y + n.z * v->a.z;
    double nb = n.x * v->b.x + n.y * v->b.y + n.z * v->b.z;
    v->normalAlong = n.x * v->cone.w.x + n.y * v->cone.w.y + n.z * v->cone.w.z;
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
    double least = v->normalAlong * v->cone.cosine;
    double excess = v->cone.sine * fma(2 * v->cone.cosine * v->normalAcross, a, v->cone.sine * (1 - a * a - disk.y * disk.y));
    double square = least * least + excess;
    double sum = square > 0 ? least + sqrt(square) : least;
    double delta = sum > 0 ? excess / sum : 0;
    double p = fma(v->normalAcross, delta, v->cone.sine * v->normalAlong * a);
    double q = v->cone.sine * disk.y;
    double middle = fma(v->cone.cosine, v->normalAcross, -v->cone.sine * a);
    double along = fma(middle, v->normalAcross, (least + delta) * v->normalAlong);
    double s = p * v->normalA - q * v->normalB;
    double t = p * v->normalB + q * v->normalA;
    setOffset(v, along, s, t, s * s + t * t);
}

// Direct light at a vertex of a path, and the weight of emission that the path hits: transport.direct.NextEventEstimation and ShadowRays.
#define ALL_AT_FIRST 4

// transport.state.PowerHeuristic
double powerWeight(double other, double own) {
    double ratio = other / own;
    return 1 / (1 + ratio * ratio);
}

bool takesAll(int lights, bool isFirst) {
    return lights <= 1 || isFirst && lights <= ALL_AT_FIRST;
}

// Whether the vertex has no light of it: it lies in its plane, or on the ball that it is.
bool isOfLight(__global const int *light, int id, int face) {
    return light[LIGHT_SURFACE] == id && (light[LIGHT_KIND] == BALL_LIGHT || light[LIGHT_KIND] == RECTANGLE_LIGHT && light[LIGHT_FACE] == face);
}

double2 drawPoint(const Sampler *sampler, bool tookAll, int index, int address) {
    return tookAll && index > 0 ? pairOfLight(sampler, index, address) : pairOf(sampler, address, LIGHT_POINT);
}

// What a light makes of a vertex if nothing is in its way: at a matte one the irradiance for radiance 1, before it is known what is in the way;
// 0 where there is none.
double unhiddenIrradiance(const Vertex *at, const Seen *v) {
    const Cone *cone = &v->view.cone;
    if (v->view.kind == POINT_LIGHT) {
        double cosine = dotOf(at->n, v->view.d);
        return cosine > 0 ? cosine / (v->view.length * v->view.length) : 0;
    }
    if (v->view.kind == RECTANGLE_LIGHT) {
        return reachesSurface(v, at->n) ? 1 : 0;
    }
    if (cone->inside) {
        return 0;
    }
    double height = dotOf(at->n, cone->w);
    return height >= cone->sine ? PI * height * cone->sine * cone->sine : irradianceOfSphere(cone, at->n);
}

// The same by the point of the light that a ray is traced to; e is that of the whole light.
double sampledIrradiance(const Vertex *at, Seen *v, double e, double probability, double2 u) {
    const Cone *cone = &v->view.cone;
    if (v->view.kind == POINT_LIGHT) {
        return e;
    }
    if (v->view.kind == BALL_LIGHT && dotOf(at->n, cone->w) >= cone->sine) {
        prepareByCosine(&v->view, at->n);
        sampleByCosine(&v->view, u.x, u.y);
        return e;
    }
    samplePoint(v, u);
    double cosine = dotOf(at->n, v->view.d);
    if (!(v->pdf > 0) || !(cosine > 0)) {
        return 0;
    }
    return v->view.kind == BALL_LIGHT ? cosine / v->pdf : cosine / v->pdf * powerWeight(cosine / PI, probability * v->pdf);
}

// What a surface that is not matte makes of the point of a light that is sampled, over radiance or intensity.
Vec scatteredFrom(Seen *v, double probability, Scattering *by, double2 u) {
    bool isPoint = v->view.kind == POINT_LIGHT;
    if (isPoint) {
        v->pdf = v->view.length * v->view.length;
    } else {
        samplePoint(v, u);
    }
    if (!(v->pdf > 0)) {
        return vec(0, 0, 0);
    }
    by->i = v->view.d;
    evaluate(by);
    double own = probability * v->pdf;
    double f = powerWeight(isPoint ? 0 : by->pdf, own) / own;
    bool any = by->value.x > 0 || by->value.y > 0 || by->value.z > 0;
    return any ? vec(f * by->value.x, f * by->value.y, f * by->value.z) : vec(0, 0, 0);
}

// Adds what a light sends to a vertex; of a matte one, to a white one in its place.
void addLightOf(Scene *s, const Vertex *at, int face, int index, double probability, Scattering *by, const Sampler *sampler, int address,
        Vec *to) {
    __global const int *light = lightOf(s, index);
    if (isOfLight(light, at->id, face) || at->leavesSmall && light[TAKES_NARROW] != 0) {
        return;
    }
    Seen v;
    s->lightSamples++;
    lookAt(s, &v, index, at->p);
    double2 u = drawPoint(sampler, at->tookAll, index, address);
    double e = 0;
    Vec f;
    if (at->isMatte) {
        e = unhiddenIrradiance(at, &v);
        f = vec(e, 0, 0);
    } else {
        f = scatteredFrom(&v, probability, by, u);
    }
    if (!(f.x > 0 || f.y > 0 || f.z > 0)) {
        return;
    }
    ulong suspects;
    int known = visibilityOf(s, at, &v, &suspects);
    if (known == SEES_NONE) {
        return;
    }
    if (at->isMatte) {
        if (known == SEES_MAYBE) {
            e = sampledIrradiance(at, &v, e, probability, u);
        } else if (v.view.kind == RECTANGLE_LIGHT) {
            e = irradianceOf(&v, at->n);
        }
        if (!(e > 0)) {
            return;
        }
        double share = e / (PI * probability);
        f = vec(share, share, share);
    }
    if (known == SEES_ALL || !isHidden(s, at, &v, suspects)) {
        __global const double *q = v.view.q;
        *to = vec(fma(f.x, q[0], to->x), fma(f.y, q[1], to->y), fma(f.z, q[2], to->z));
    }
}

// The direct light at a vertex: where it is matte, that which a white surface would reflect.
Vec directLight(Scene *s, const Vertex *at, int face, Scattering *by, const Sampler *sampler, int address) {
    Vec sum = vec(0, 0, 0);
    int lights = s->i[LIGHT_COUNT];
    Choice choice;
    choice.light = 0;
    choice.probability = 1;
    if (!at->tookAll) {
        if (!chooseLight(s, at->p, at->n, pairOf(sampler, address, CHOICE).x, &choice)) {
            return sum;
        }
        lights = choice.light + 1;
    }
    for (int k = choice.light; k < lights; k++) {
        addLightOf(s, at, face, k, choice.probability, by, sampler, address, &sum);
    }
    return sum;
}

// Whether a matte vertex has all of a light from its closed form.
bool isClosed(Scene *s, const Vertex *at, const Seen *v) {
    if (v->view.kind == BALL_LIGHT) {
        return irradianceOf(v, at->n) > 0;
    }
    ulong suspects;
    return reachesSurface(v, at->n) && visibilityOf(s, at, v, &suspects) != SEES_MAYBE;
}

// The weight of emission that the path hits, beside what the vertex has sampled of the light.
double weightOfHit(Scene *s, const Vertex *at, double pdf, int index, const Ray *ray, const Hit *hit) {
    if (index < 0) {
        return 1;
    }
    __global const int *light = lightOf(s, index);
    if (light[LIGHT_KIND] == BALL_LIGHT && light[LIGHT_SURFACE] == at->id) {
        return 1;
    }
    Seen v;
    lookAt(s, &v, index, at->p);
    if (at->isMatte && isClosed(s, at, &v)) {
        return 0;
    }
    double density = densityOfHit(&v, ray, hit);
    if (!(density > 0)) {
        return 1;
    }
    Choice choice;
    double probability = at->tookAll ? 1 : probabilityOfLight(s, index, at->p, at->n, &choice);
    return powerWeight(probability * density, pdf);
}

// The radiance along one camera ray by the rendering equation: transport.path.PathIntegrator with transport.ray.PathFollower,
// transport.state.PathState, PathValue and transport.path.CausticPassShare. Where surfaces touch, and where a ray is too large or too small, the
// sample is left to the host.
#define ROULETTE_FROM 5
#define FAINT 0.05
#define LARGEST_SURVIVAL 0.99

// transport.state.PathEvent
#define NO_EVENT 0
#define SPECULAR_EVENT 1
#define NARROW_EVENT 2
#define WIDE_EVENT 3

typedef struct {
    Sampler sampler;
    // The surfaces left behind, bounces, surfaces passed straight since the last; events, those of them that are not specular, and those that
    // count for roulette after the last (transport.state.PathState); the address of the next random numbers.
    int surfaces;
    int bounces;
    int straight;
    int events;
    int scatterings;
    int eventsForRoulette;
    int address;
    // The first event, and the first that was none in a single direction.
    int first;
    int firstScattering;
    // Whether direct light was sampled at the last event, at which vertex, and the density of the direction in which the path left that.
    bool hasDirect;
    bool leftSmallLights;
    Vertex vertex;
    double pdf;
    Ray ray;
    Hit hit;
    // The shading normal on the side that the path came from; another than the surface's own where that is smooth.
    Vec normal;
    bool isSmooth;
    Solids solids;
    Vec throughput;
    // Radiance at the eye per radiance here, where the index of refraction is another one.
    double compression;
    Vec light;
} Path;

void addRadiance(Path *path, double r, double g, double b) {
    path->light.x = fma(path->throughput.x * path->compression, r, path->light.x);
    path->light.y = fma(path->throughput.y * path->compression, g, path->light.y);
    path->light.z = fma(path->throughput.z * path->compression, b, path->light.z);
}

void filterPath(Path *path, double r, double g, double b) {
    path->throughput.x *= r;
    path->throughput.y *= g;
    path->throughput.z *= b;
}

// Multiplies by the weight of an event, and plays roulette where it is due.
bool survives(Path *path, Vec weight) {
    filterPath(path, weight.x, weight.y, weight.z);
    double left = larger(fabs(path->throughput.x), larger(fabs(path->throughput.y), fabs(path->throughput.z)));
    if (path->eventsForRoulette < ROULETTE_FROM && left >= FAINT) {
        return true;
    }
    if (!(left > 0)) {
        return false;
    }
    double survival = smaller(larger(weight.x, larger(weight.y, weight.z)), LARGEST_SURVIVAL);
    if (!(unitOf(&path->sampler, path->events, ROULETTE) < survival)) {
        return false;
    }
    double scale = 1 / survival;
    filterPath(path, scale, scale, scale);
    return true;
}

// Counts the event that the path leaves behind; whether it may go on.
bool continues(const Scene *s, Path *path) {
    path->surfaces++;
    path->straight = 0;
    return ++path->bounces <= s->i[MAX_BOUNCES];
}

void appendEvent(Path *path, int event) {
    if (path->first == NO_EVENT) {
        path->first = event;
    }
    bool scatters = event != SPECULAR_EVENT;
    path->scatterings += scatters ? 1 : 0;
    path->eventsForRoulette = scatters ? path->scatterings : path->events + 1;
    if (scatters && path->firstScattering == NO_EVENT) {
        path->firstScattering = event;
    }
}

void extendSpecular(Path *path) {
    appendEvent(path, SPECULAR_EVENT);
    path->hasDirect = false;
}

void extend(Path *path, int event, double pdf, bool leavesSmall) {
    appendEvent(path, event);
    path->hasDirect = true;
    path->leftSmallLights = leavesSmall;
    path->pdf = pdf;
}

// Whether the caustic pass samples such paths if their last event is specular and a light comes next.
bool isOfCausticPass(const Path *path) {
    return path->firstScattering != NO_EVENT && path->first != SPECULAR_EVENT;
}

// The weight of emission that the path hits.
double weightOfEmission(Scene *s, Path *path, int light) {
    if (s->i[HAS_CAUSTIC_PASS] != 0 && light >= 0) {
        bool isOfPass = path->hasDirect ? path->leftSmallLights && lightOf(s, light)[TAKES_NARROW] != 0 : isOfCausticPass(path);
        if (isOfPass) {
            return 0;
        }
    }
    return path->hasDirect ? weightOfHit(s, &path->vertex, path->pdf, light, &path->ray, &path->hit) : 1;
}

void addEmission(Scene *s, Path *path, __global const int *material) {
    int side = path->hit.side == OUTSIDE ? 1 : 2;
    if ((material[GLOWING_SIDES] & side) == 0) {
        return;
    }
    int lights = primitive(s, path->hit.id)[FACE_LIGHTS];
    double weight = weightOfEmission(s, path, lights < 0 ? NOTHING : s->i[lights + path->hit.face]);
    if (weight > 0) {
        __global const double *q = s->d + material[MATERIAL_NUMBERS] + GLOW;
        addRadiance(path, weight * q[0], weight * q[1], weight * q[2]);
    }
}

// Sets the vertex at which direct light is gathered.
void setVertex(const Scene *s, Path *path, bool isMatte, bool leavesSmall) {
    Vertex *v = &path->vertex;
    const Hit *hit = &path->hit;
    int traits = primitive(s, hit->id)[TRAITS];
    v->p = hit->p;
    v->n = path->normal;
    v->id = hit->id;
    v->element = hit->element;
    v->side = hit->side;
    v->neverReturns = (traits & IS_FLAT) != 0 || (traits & IS_CONVEX) != 0 && hit->side == OUTSIDE;
    v->isMatte = isMatte;
    v->tookAll = takesAll(s->i[LIGHT_COUNT], path->firstScattering == NO_EVENT);
    v->leavesSmall = leavesSmall;
}

// Lets the path leave the surface in the direction that was sampled. What it may meet of borders that coincide is left to the host.
void leaveSurface(Scene *s, Path *path, const Scattering *by) {
    const Hit *hit = &path->hit;
    setRay(s, &path->ray, hit->p.x, hit->p.y, hit->p.z, by->i.x, by->i.y, by->i.z, 0);
    startOn(&path->ray, hit, by->transmitted ? -hit->side : hit->side);
    if (isInGlassBox(s, hit->p)) {
        s->state = LEFT_TO_HOST;
    }
}

void arrive(const Path *path, __global const int *material, const Scene *s, Vec color, Scattering *by) {
    const Ray *r = &path->ray;
    const Hit *hit = &path->hit;
    double scale = 1 / sqrt(r->dd);
    by->kind = material[MATERIAL_KIND];
    by->q = s->d + material[MATERIAL_NUMBERS] + BSDF_NUMBERS;
    by->isSmooth = path->isSmooth;
    by->o = vec(-r->dx * scale, -r->dy * scale, -r->dz * scale);
    by->n = path->normal;
    by->g = vec(hit->n.x * hit->side, hit->n.y * hit->side, hit->n.z * hit->side);
    by->color = color;
}

bool reflect(Scene *s, Path *path, Scattering *by) {
    if (!sampleBsdf(by, (double2)(0, 0), 0)) {
        return false;
    }
    s->mirrorRays++;
    leaveSurface(s, path, by);
    extendSpecular(path);
    return survives(path, by->value) && continues(s, path);
}

// Whether images of lamps in mirror balls are sampled at the vertex (transport.image.MirrorCaustics): those are left to the host.
bool seesMirroredLamps(const Scene *s, const Path *path) {
    return s->i[HAS_MIRROR_BALLS] != 0 && path->first == SPECULAR_EVENT && path->bounces <= s->i[MAX_BOUNCES] - 2
            && mediumOf(s, &path->solids) == NOTHING;
}

// At any other surface: adds direct light, and samples the direction in which the path goes on. Shadow rays in media that absorb light are
// left to the host.
bool scatter(Scene *s, Path *path, __global const int *material, Scattering *by) {
    if (seesMirroredLamps(s, path) || absorbsLight(s, mediumOf(s, &path->solids))) {
        s->state = LEFT_TO_HOST;
        return false;
    }
    bool isMatte = by->kind == MATTE && !by->isSmooth;
    bool isNarrow = material[IS_NARROW] != 0;
    bool leaves = isNarrow && isOfCausticPass(path) && path->firstScattering != NARROW_EVENT;
    setVertex(s, path, isMatte, leaves);
    Vec light = directLight(s, &path->vertex, path->hit.face, by, &path->sampler, path->address);
    double2 u = pairOf(&path->sampler, path->address, DIRECTION);
    double choice = unitOf(&path->sampler, path->address++, CHOICE);
    if (isMatte) {
        addRadiance(path, by->color.x * light.x, by->color.y * light.y, by->color.z * light.z);
        sampleMatte(by, u);
        by->value = by->color;
    } else {
        addRadiance(path, light.x, light.y, light.z);
        if (!sampleBsdf(by, u, choice)) {
            return false;
        }
    }
    leaveSurface(s, path, by);
    if (by->delta && !isNarrow) {
        extendSpecular(path);
    } else {
        extend(path, isNarrow ? NARROW_EVENT : WIDE_EVENT, by->pdf, leaves);
    }
    return by->pdf > 0 && survives(path, by->value) && continues(s, path);
}

// At an opaque surface; whether the path goes on.
bool shadeOpaque(Scene *s, Path *path, __global const int *material) {
    if (material[GLOWING_SIDES] != 0) {
        addEmission(s, path, material);
    }
    if (material[IS_BLACK] != 0 || path->bounces > s->i[MAX_BOUNCES] - 1) {
        return false;
    }
    Scattering by;
    arrive(path, material, s, colorAt(s, &path->hit, material), &by);
    if (material[IS_DELTA] != 0) {
        return reflect(s, path, &by);
    }
    return scatter(s, path, material, &by);
}

// The same of a surface that did not turn the ray, which is no bounce.
bool goesOnStraight(const Scene *s, Path *path) {
    path->surfaces++;
    return ++path->straight <= s->i[MAX_STRAIGHT];
}

// Lets the ray leave a border of two media, refracted or reflected (transport.ray.GlassScattering); whether any light is left.
bool turnAtBorder(Scene *s, Path *path, __global const int *material, double eta, double choice, bool *through) {
    const Hit *hit = &path->hit;
    Scattering by;
    arrive(path, material, s, vec(1, 1, 1), &by);
    by.eta = eta;
    if (!sampleBorder(&by, choice)) {
        return false;
    }
    *through = by.transmitted;
    setRay(s, &path->ray, hit->p.x, hit->p.y, hit->p.z, by.i.x, by.i.y, by.i.z, 0);
    startOn(&path->ray, hit, by.transmitted ? -hit->side : hit->side);
    s->refractedRays += by.transmitted ? 1 : 0;
    s->mirrorRays += by.transmitted ? 0 : 1;
    return true;
}

// Crosses a border of smooth glass or is reflected there: transport.ray.GlassTracer.
bool crossGlass(Scene *s, Path *path, __global const int *material) {
    Ray *r = &path->ray;
    const Hit *hit = &path->hit;
    double2 u = pairOf(&path->sampler, path->address++, CHOICE);
    Solids before = path->solids;
    int from = mediumOf(s, &before);
    if (primitive(s, hit->id)[IS_SOLID] == 0) {
        s->state = LEFT_TO_HOST;
        return false;
    }
    crossBorder(s, &path->solids, hit->id, hit->side);
    int to = mediumOf(s, &path->solids);
    double fromIndex = indexOf(s, from);
    double toIndex = indexOf(s, to);
    bool isStraight = from == to || fromIndex == toIndex;
    bool through = true;
    if (isStraight) {
        setRay(s, r, hit->p.x, hit->p.y, hit->p.z, r->dx, r->dy, r->dz, 0);
        startOn(r, hit, -hit->side);
    } else {
        if (!turnAtBorder(s, path, material, fromIndex / toIndex, u.x, &through)) {
            return false;
        }
        if (!through) {
            path->solids = before;
        }
    }
    Vec weight = vec(1, 1, 1);
    if (through && from != to) {
        weight = colorAt(s, hit, material);
    }
    double index = indexOf(s, mediumOf(s, &path->solids));
    path->compression = 1 / (index * index);
    if (isStraight) {
        path->events--;
        filterPath(path, weight.x, weight.y, weight.z);
        return goesOnStraight(s, path);
    }
    extendSpecular(path);
    return survives(path, weight) && continues(s, path);
}

// Multiplies the throughput by the transmittance of a medium along the ray up to its hit: transport.state.PathValue.
void absorb(const Scene *s, Path *path, int medium) {
    __global const double *a = numbersOfMedium(s, medium) + ABSORPTION;
    double length = (path->hit.t - path->ray.tMin) * sqrt(path->ray.dd);
    filterPath(path, expOf(-a[0] * length), expOf(-a[1] * length), expOf(-a[2] * length));
}

// Follows the ray to the next vertex and shades it; whether the path goes on.
bool step(Scene *s, Path *path) {
    Closest best;
    best.t = DBL_MAX;
    best.id = NOTHING;
    search(s, &path->ray, false, 0, &best);
    if (best.id == NOTHING) {
        addRadiance(path, s->d[BACKGROUND], s->d[BACKGROUND + 1], s->d[BACKGROUND + 2]);
        return false;
    }
    path->ray.element = best.element;
    completeOf(s, best.id, &path->ray, best.t, &path->hit);
    const Hit *hit = &path->hit;
    if (touchesOther(s, hit)) {
        s->state = LEFT_TO_HOST;
        return false;
    }
    int medium = mediumOf(s, &path->solids);
    if (absorbsLight(s, medium)) {
        absorb(s, path, medium);
    }
    __global const int *material = materialAt(s, hit);
    Vec n = hit->n;
    // Glass has only one kind of border with normals of vertices.
    bool mayBeSmooth = material[IS_GLASS] == 0 || material[MATERIAL_KIND] == SMOOTH_GLASS;
    path->isSmooth = mayBeSmooth && shadingNormal(s, hit, &n);
    path->normal = vec(n.x * hit->side, n.y * hit->side, n.z * hit->side);
    return material[IS_GLASS] != 0 ? crossGlass(s, path, material) : shadeOpaque(s, path, material);
}

bool follow(Scene *s, Path *path) {
    if (!step(s, path)) {
        return false;
    }
    path->events++;
    return true;
}

void beginPath(Path *path) {
    path->events = 0;
    path->scatterings = 0;
    path->address = 0;
    path->first = NO_EVENT;
    path->firstScattering = NO_EVENT;
    path->hasDirect = false;
    path->compression = 1;
}

package enlightenment.importer.pbrt;

import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.scene.Shading;
import enlightenment.text.Plain;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;

/** Reads the directives of a scene one after the other. */
final class Directives {
    /** The deepest nesting of blocks. */
    private static final int DEEPEST = 10_000;

    /** pbrt's limit on the length of paths where none is given. */
    private static final int USUAL_DEPTH = 5;

    private static final Set<String> SETTINGS = Set.of("Sampler", "PixelFilter", "Accelerator", "ColorSpace", "Option");

    /** The directives between which a kept state is restored. */
    private record Block(String begin, GraphicsState kept) {}

    /** Reads the rest of a directive. */
    private interface Handler {
        void read(Place place) throws IOException;
    }

    private final TokenSource in;
    private final ImportDraft draft;
    private final Transformations transformations;
    private final Textures textures;
    private final Materials materials;
    private final Media media;
    private final Shapes shapes;
    private final Lights lights;
    private final GlowingShapes lamps;
    private final Views views;
    private final World world = new World();
    private final Deque<Block> blocks = new ArrayDeque<>();
    private final Map<String, Handler> handlers = new HashMap<>();
    private GraphicsState state;
    private boolean isWorld;
    private String cameraMedium = "";

    Directives(TokenSource in, ImportDraft draft, ExtractedFiles extracted) {
        this.in = in;
        this.draft = draft;
        state = new GraphicsState(in.place());
        Spectra spectra = new Spectra(in);
        transformations = new Transformations(in, draft.notes());
        DerivedPictures pictures = new DerivedPictures(extracted);
        textures = new Textures(in, spectra, draft.notes(), pictures);
        materials = new Materials(textures, spectra, draft.notes());
        media = new Media(spectra, draft.notes());
        shapes = new Shapes(in, draft.notes());
        lights = new Lights(in, spectra, draft, extracted, pictures);
        lamps = new GlowingShapes(spectra, draft, in, pictures);
        views = new Views(draft.notes());
        draft.maxBounces(USUAL_DEPTH);
        addHandlers();
        addBlocks();
    }

    private void addHandlers() {
        handlers.put("Camera", this::camera);
        handlers.put("Film", place -> {
            name();
            views.film(parameters(""));
        });
        handlers.put("Integrator", place -> {
            name();
            draft.maxBounces(parameters("").integer("maxdepth", USUAL_DEPTH, 0, Shading.Physical.MAX_BOUNCES));
        });
        handlers.put("WorldBegin", this::beginWorld);
        handlers.put("ReverseOrientation", place -> state.isReversed = !state.isReversed);
        handlers.put("Attribute", place -> {
            String target = name();
            state.addDefaults(target, ParameterReader.read(in));
        });
        handlers.put("Include", place -> in.include(name(), false));
        handlers.put("Import", place -> {
            in.include(name(), true);
            push("Import", place);
        });
        handlers.put("MediumInterface", this::mediumInterface);
        handlers.put("MakeNamedMedium", place -> media.define(name(), parameters("medium"), state.space));
        handlers.put("Material", place -> {
            String type = name();
            state.material = new MaterialSource(type, "", parameters("material"), state.space);
        });
        handlers.put("MakeNamedMaterial", place -> {
            String name = name();
            Parameters p = parameters("material");
            materials.define(name, new MaterialSource(p.string("type", ""), "", p, state.space));
        });
        handlers.put("NamedMaterial", place -> state.material = MaterialSource.named(name(), place));
        handlers.put("Texture", this::texture);
        handlers.put("Shape", this::shape);
        handlers.put("LightSource", place -> {
            String type = name();
            lights.add(type, parameters("light"), state.ctm, state.space);
        });
        handlers.put("AreaLightSource", this::areaLight);
        handlers.put("ObjectInstance", place -> world.addInstance(name(), state.ctm, place));
        SETTINGS.forEach(s -> handlers.put(s, place -> setting(s, place)));
    }

    private void addBlocks() {
        handlers.put("AttributeBegin", place -> push("AttributeBegin", place));
        handlers.put("AttributeEnd", place -> state = pop("AttributeBegin", place));
        handlers.put("TransformBegin", place -> push("TransformBegin", place));
        handlers.put("TransformEnd", place -> state.ctm = pop("TransformBegin", place).ctm);
        handlers.put("ObjectBegin", place -> {
            world.beginObject(name(), place);
            push("ObjectBegin", place);
        });
        handlers.put("ObjectEnd", place -> {
            world.endObject(place);
            state = pop("ObjectBegin", place);
        });
    }

    /** Reads all directives and makes the scene. */
    void read() throws IOException {
        Place start = in.place();
        for (Token t = in.next(); t != null; t = in.next()) {
            directive(t);
        }
        if (!blocks.isEmpty()) {
            throw in.place().failure("the file ends, but " + blocks.peek().begin() + " has no end");
        }
        views.addTo(draft, start);
        Assembly assembly = new Assembly(materials, textures, media, lamps, draft);
        world.forEach(assembly::add);
        if (media.find(cameraMedium, start).isPresent()) {
            draft.notes().add("", "the medium that the camera stands in is left out");
        }
        materials.used().forEach((name, surface) -> {
            if (!surface.isInterface()) {
                draft.material(name, surface.material());
            }
        });
    }

    private void directive(Token t) throws IOException {
        Place place = t.place();
        if (t.kind() == Token.Kind.FILE_END) {
            state = pop("Import", place);
            return;
        }
        if (t.kind() != Token.Kind.WORD) {
            throw place.failure("expected a directive, such as Shape, not " + Plain.quoted(t.text()));
        }
        if (Transformations.has(t.text())) {
            transformations.apply(t.text(), state);
            return;
        }
        Handler handler = handlers.get(t.text());
        if (handler == null) {
            throw place.failure("pbrt-v4 has no directive " + Plain.quoted(t.text()));
        }
        try {
            handler.read(place);
        } catch (IllegalArgumentException e) {
            throw place.failure(t.text() + ": " + e.getMessage());
        }
    }

    private String name() throws IOException {
        return in.expect(Token.Kind.STRING, "a name in quotation marks").text();
    }

    private Parameters parameters(String target) throws IOException {
        return state.with(target, ParameterReader.read(in));
    }

    private void push(String begin, Place place) {
        if (blocks.size() == DEEPEST) {
            throw place.failure("blocks are nested deeper than " + DEEPEST);
        }
        blocks.push(new Block(begin, state));
        state = state.copy();
    }

    private GraphicsState pop(String begin, Place place) {
        if (blocks.isEmpty() || !blocks.peek().begin().equals(begin)) {
            throw place.failure("an end without " + begin
                    + (blocks.isEmpty() ? "" : "; " + blocks.peek().begin() + " is open"));
        }
        return blocks.pop().kept();
    }

    private void setting(String directive, Place place) throws IOException {
        if (directive.equals("Option")) {
            ParameterReader.read(in);
        } else if (directive.equals("ColorSpace")) {
            String name = name();
            state.space = ColorSpace.of(name)
                    .orElseThrow(() ->
                            place.failure("expected srgb, dci-p3, rec2020 or aces2065-1, not " + Plain.quoted(name)));
        } else {
            name();
            ParameterReader.read(in);
        }
    }

    private void camera(Place place) throws IOException {
        String type = name();
        views.camera(type, parameters(""), state.ctm);
        transformations.name("camera", views.cameraToWorld());
        cameraMedium = state.outsideMedium;
    }

    private void beginWorld(Place place) {
        if (isWorld || !blocks.isEmpty()) {
            throw place.failure(
                    isWorld ? "WorldBegin stands twice" : blocks.peek().begin() + " has no end");
        }
        isWorld = true;
        state.ctm = Affine.IDENTITY;
        state.isFirstKeyActive = true;
        transformations.name("world", state.ctm);
    }

    private void mediumInterface(Place place) throws IOException {
        state.insideMedium = name();
        Token next = in.peek();
        state.outsideMedium = next != null && next.kind() == Token.Kind.STRING ? name() : state.insideMedium;
    }

    private void texture(Place place) throws IOException {
        String name = name();
        String type = name();
        if (!type.equals("float") && !type.equals("spectrum")) {
            throw place.failure("a texture is of the type float or spectrum, not " + Plain.quoted(type));
        }
        String kind = name();
        textures.define(name, type.equals("spectrum"), new TextureDefinition(kind, parameters("texture"), state.space));
    }

    private void shape(Place place) throws IOException {
        String type = name();
        Parameters p = parameters("shape");
        boolean isLampInObject = world.isObjectOpen() && state.areaLight != null;
        if (isLampInObject) {
            draft.notes().add(place.shown(), "lamps in objects that have instances do not shine");
        }
        shapes.read(type, p)
                .ifPresent(form -> world.add(new ShapeDefinition(
                        form,
                        state.ctm,
                        state.isReversed,
                        p,
                        state.material,
                        isLampInObject ? null : state.areaLight,
                        state.areaLightSpace,
                        state.insideMedium)));
    }

    private void areaLight(Place place) throws IOException {
        String type = name();
        Parameters p = parameters("light");
        if (!type.equals("diffuse")) {
            throw place.failure("pbrt-v4 has no area light of the kind " + Plain.quoted(type));
        }
        state.areaLight = p;
        state.areaLightSpace = state.space;
    }
}

package enlightenment.scene.json;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A file format of other programs for scenes or meshes. It is recognized only after a file has been refused as a scene, for a message with the
 * kind of the file and advice.
 */
enum ForeignFormat {
    PLY("a mesh in the Stanford PLY format", Advice.MESH, Comments.NONE, "ply[\\r\\n]", "ply"),
    STL(
            "a mesh in the STL format",
            Advice.MESH,
            Comments.NONE,
            "solid\\b[^\\n]*\\n\\s*(facet\\s+normal|endsolid)",
            "stl"),
    GLTF(
            "a scene in the glTF format",
            Advice.SCENE,
            Comments.NONE,
            "glTF|\\{.*\"asset\"\\s*:\\s*\\{[^}]{0,1000}\"version\"\\s*:\\s*\"[0-9]",
            "glb",
            "gltf"),
    FBX("a scene in Autodesk's FBX format", Advice.SCENE, Comments.NONE, "Kaydara FBX Binary|; FBX ", "fbx"),
    BLENDER("a scene of Blender's", Advice.SCENE, Comments.NONE, "BLENDER", "blend"),
    SERIALIZED(
            "a mesh in Mitsuba's serialized format",
            Advice.MESH,
            Comments.NONE,
            "\\x1c\\x04[\\x03\\x04]\\x00",
            "serialized"),
    USD("a scene in the USD format", Advice.SCENE, Comments.NONE, "#usda |PXR-USDC", "usd", "usda", "usdc", "usdz"),
    COLLADA("a scene in the COLLADA format", Advice.SCENE, Comments.NONE, "<(.*<)?COLLADA[\\s>]", "dae"),
    MITSUBA("a scene of Mitsuba's", Advice.SCENE, Comments.NONE, "<(.*<)?scene\\s[^>]{0,1000}\\bversion\\s*="),
    XML("an XML file", Advice.SCENE, Comments.NONE, "<\\?xml\\s", "xml"),
    NFF("a scene in the Neutral File Format", Advice.CONVERT, Comments.HASH, "v\\s*\\n\\s*from\\s", "nff"),
    OBJ(
            "a mesh in the Wavefront OBJ format",
            Advice.MESH,
            Comments.HASH,
            "((mtllib|usemtl|o|g|s)\\s.*?\\n)?v(\\s+[-+.0-9eE]+){3}",
            "obj"),
    PBRT(
            "a scene of pbrt's",
            Advice.SCENE,
            Comments.HASH,
            "(LookAt|Camera|Film|PixelFilter|Sampler|(Surface)?Integrator|Renderer|Accelerator|Option|ColorSpace"
                    + "|Transform|ConcatTransform|Scale|Translate|Rotate|Identity|WorldBegin|AttributeBegin|Include|Import"
                    + "|Texture|Material|MakeNamedMaterial|MakeNamedMedium|Shape|LightSource)[\\s\"\\[]",
            "pbrt"),
    POV_RAY(
            "a scene of POV-Ray's",
            Advice.SCENE,
            Comments.SLASH,
            "#\\s*(include\\s*\"|version\\s|declare\\s|default\\s|local\\s|macro\\s)"
                    + "|(global_settings|camera|background|light_source)\\s*\\{",
            "pov");

    /** Number of bytes at the beginning of a file that are examined. */
    static final int START = 1 << 16;

    private static final int STL_HEADER = 84;
    private static final int STL_TRIANGLE = 50;

    private final String description;
    private final String advice;
    private final Comments comments;
    private final Pattern content;
    private final List<String> extensions;

    /** @param content pattern of the start of a file behind blanks and comments, each byte a character */
    ForeignFormat(String description, String advice, Comments comments, String content, String... extensions) {
        this.description = description;
        this.advice = advice;
        this.comments = comments;
        this.content = Pattern.compile(content, Pattern.DOTALL);
        this.extensions = List.of(extensions);
    }

    /** Comments that are skipped before the content of a file, beside blanks. */
    private enum Comments {
        NONE,
        /** Comments from a # to the end of the line. */
        HASH,
        /** Comments of C++. */
        SLASH;

        private static final String BLANKS = " \t\r\n";

        /** The index behind blanks and comments at the beginning of a text. */
        int end(String text) {
            int at = 0;
            while (at < text.length()) {
                if (BLANKS.indexOf(text.charAt(at)) >= 0) {
                    at++;
                } else if (this == HASH && text.startsWith("#", at) || this == SLASH && text.startsWith("//", at)) {
                    at = after(text, "\n", at);
                } else if (this == SLASH && text.startsWith("/*", at)) {
                    at = after(text, "*/", at + 2);
                } else {
                    return at;
                }
            }
            return at;
        }

        private static int after(String text, String end, int from) {
            int at = text.indexOf(end, from);
            return at < 0 ? text.length() : at + end.length();
        }
    }

    /** Advice at the end of messages. */
    private static final class Advice {
        static final String MESH =
                "a scene can have it as an object {\"type\": \"mesh\", \"file\": ...}, see docs/guide/scene-format.md";
        static final String SCENE =
                "it cannot be read yet; a scene is JSON as docs/guide/scene-format.md describes it, and 'enlightenment"
                        + " convert' makes it of NFF files only";
        static final String CONVERT = "'enlightenment convert IN.nff OUT.json' makes a scene file of it";

        private Advice() {}
    }

    /**
     * The format of a file that is no scene; empty if it is unknown.
     *
     * @param name the file's name, whose extension decides where the content does not; may be ""
     * @param start the file's first {@link #START} bytes; fewer if it has fewer
     * @param size the size of the file in bytes
     */
    static Optional<ForeignFormat> of(String name, byte[] start, long size) {
        if (isBinaryStl(start, size)) {
            return Optional.of(STL);
        }
        String text = new String(start, StandardCharsets.ISO_8859_1);
        String content = text.startsWith("\u00ef\u00bb\u00bf") ? text.substring(3) : text;
        for (ForeignFormat format : values()) {
            Matcher matcher = format.content.matcher(content);
            if (matcher.region(format.comments.end(content), content.length()).lookingAt()) {
                return Optional.of(format);
            }
        }
        // Such a file is meant as a scene, whatever its extension.
        boolean isJson = content.isBlank() || content.stripLeading().startsWith("{");
        String extension = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        for (ForeignFormat format : values()) {
            if (format.extensions.contains(extension) && extension.length() < name.length() && !isJson) {
                return Optional.of(format);
            }
        }
        return Optional.empty();
    }

    /** Whether a file has the size of a binary STL with its number of triangles: the format has no signature. */
    private static boolean isBinaryStl(byte[] start, long size) {
        if (start.length < STL_HEADER) {
            return false;
        }
        long triangles = 0;
        for (int i = 1; i <= Integer.BYTES; i++) {
            triangles = triangles << Byte.SIZE | start[STL_HEADER - i] & 0xff;
        }
        return triangles > 0 && size == STL_HEADER + STL_TRIANGLE * triangles;
    }

    /** The message for a file of this format, which follows the file's name. */
    String refusal() {
        return "is " + description + ", not a scene file: " + advice;
    }
}

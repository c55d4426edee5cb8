package enlightenment.cli;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Command lines of all commands that write files, for tests that put their files into each other's places. */
enum CommandLines {
    RENDER(List.of("SCENE", "texture"), "-o", "--report", "--aov", "--denoised", "--dump-clusters", "--dump-chains"),
    RENDER_KEPT(
            List.of("SCENE", "texture", "--store-password-file"), "-o", "--report", "--aov", "--checkpoint", "--store"),
    /** Of a film with one frame. */
    ANIMATE(List.of("SCENE", "texture", "--ffmpeg"), "-o", "--aov", "--video", "--report"),
    ANIMATE_SERVER(
            List.of("SCENE", "texture", "--ffmpeg", "--tls-cert", "--tls-key"),
            "-o",
            "--video",
            "--report",
            "--token-file",
            "--tls"),
    RENDER_PART(List.of("SCENE", "texture"), "-o"),
    CONVERT(List.of("IN"), "OUT.json"),
    CONVERT_BY_OPTION(List.of("IN"), "-o"),
    COMPARE(List.of("A", "B"), "--heatmap"),
    MERGE(List.of("PART"), "-o", "--report"),
    SERVER(
            List.of("SCENE", "texture", "--tls-cert", "--tls-key", "--store-password-file"),
            "-o",
            "--report",
            "--checkpoint",
            "--store",
            "--token-file",
            "--tls"),
    TRADE(List.of("SCENE", "texture", "--reference"), "-o"),
    RENDER_STORE(List.of("STORE", "--store-password-file"), "-o", "--report"),
    STORE_EXPORT(List.of("STORE", "--store-password-file"), "--csv"),
    BENCH(List.of("--scenes", "texture"), "--json");

    /** What {@code %04d} of a frame's file is in a film with one frame. */
    private static final String FRAME = "0000";

    private static final String NFF =
            """
            v
            from 0 0 -5
            at 0 0 0
            up 0 1 0
            angle 45
            hither 0.01
            resolution 16 16
            l 2 3 -2
            f 1 1 1 1 0 0 0 0
            s 0 0 0 1
            """;

    /** What is read, and what is written, by the names of options and parameters; textures are in scenes. */
    final List<String> inputs;

    final List<String> outputs;

    CommandLines(List<String> inputs, String... outputs) {
        this.inputs = inputs;
        this.outputs = List.of(outputs);
    }

    String command() {
        return switch (this) {
            case RENDER_PART, RENDER_KEPT -> "render";
            case ANIMATE_SERVER -> "animate";
            case CONVERT_BY_OPTION -> "convert";
            default -> name().toLowerCase(java.util.Locale.ROOT).replace('_', '-');
        };
    }

    private boolean isFilm() {
        return this == ANIMATE || this == ANIMATE_SERVER;
    }

    /** Whether there are so many pairs of files that not each can be tried by each name within a moment. */
    boolean hasMany() {
        return outputs.size() > 3;
    }

    /** What the name of that output must end in. */
    String extension(String output) {
        return switch (output) {
            case "-o" ->
                this == CONVERT_BY_OPTION
                        ? ".json"
                        : this == RENDER_PART ? ".film" : isFilm() ? FRAME + ".png" : ".png";
            case "--aov" -> isFilm() ? FRAME + ".depth.png" : ".depth.png";
            case "--heatmap", "--denoised" -> ".png";
            case "--video" -> ".gif";
            case "--dump-clusters", "--dump-chains", "OUT.json" -> ".json";
            case "IN" -> ".nff";
            default -> "";
        };
    }

    /** Makes an input, if need be in a place that is told. */
    static void make(String input, Path file, Path folder) throws IOException {
        switch (input) {
            case "SCENE", "--scenes" -> Files.writeString(file, scene("texture.png"));
            case "texture", "A", "B", "--reference" -> picture(file, folder);
            case "IN" -> Files.writeString(file, NFF);
            case "PART" -> part(file, folder);
            default -> Files.writeString(file, "precious " + input);
        }
    }

    private static void picture(Path file, Path folder) throws IOException {
        Path png = folder.resolve("made.png");
        ImageFiles.writePng(new Image(8, 8, new float[3 * 64]), png);
        Files.move(png, file);
    }

    private static void part(Path file, Path folder) throws IOException {
        Path scene = CliRun.scene(folder, "\"width\": 8, \"height\": 8");
        Path part = folder.resolve("made.film");
        CliRun run = CliRun.of("render", scene, "--part", "1/1", "-o", part, "--progress", "none");
        if (run.code() != 0) {
            throw new IOException(run.err());
        }
        Files.move(part, file);
    }

    private static String scene(String texture) {
        return """
                {
                  "image": { "width": 8, "height": 8 },
                  "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0],
                              "fieldOfView": 40 },
                  "textures": { "used": { "file": "TEXTURE" }, "never used": { "file": "TEXTURE" } },
                  "materials": { "white": { "type": "matte", "color": { "texture": "used" } } },
                  "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff" } ],
                  "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "white" } ],
                  "animation": { "frames": 1, "framesPerSecond": 25, "tracks": [] }
                }
                """
                .replace("TEXTURE", texture);
    }

    /** What is typed where these are the files of inputs and outputs; a scene reads its texture at {@code texture}. */
    List<Object> args(Map<String, Path> files, Path folder) throws IOException {
        if (files.containsKey("texture")) {
            Path scene = this == BENCH ? files.get("--scenes") : files.get("SCENE");
            Files.write(
                    scene, scene(files.get("texture").getFileName().toString()).getBytes(StandardCharsets.UTF_8));
        }
        List<Object> args = new ArrayList<>(List.of(command()));
        for (String input : inputs) {
            switch (input) {
                case "texture" -> {}
                case "--scenes" -> args.addAll(List.of(input, files.get(input).getParent()));
                case "--tls-cert", "--tls-key" -> {
                    if (!files.containsKey("--tls")) {
                        args.addAll(List.of(input, files.get(input)));
                    }
                }
                case "--reference", "--ffmpeg", "--store-password-file" ->
                    args.addAll(List.of(input, files.get(input)));
                default -> args.add(files.get(input));
            }
        }
        for (String output : outputs) {
            Path file = files.get(output);
            if (file == null && output.equals("-o")) {
                file = folder.resolve(this == TRADE ? "new" : "new" + extension(output));
            }
            if (file != null) {
                add(args, output, file);
            }
        }
        if (inputs.contains("--store-password-file") && !inputs.contains("STORE") && !args.contains("--store")) {
            args.addAll(List.of("--store", folder.resolve("new.store")));
        }
        if (inputs.contains("--ffmpeg") && !args.contains("--video")) {
            args.addAll(List.of("--video", folder.resolve("new.gif")));
        }
        if (this == RENDER_PART) {
            args.addAll(List.of("--part", "1/2"));
        }
        if (this == ANIMATE_SERVER) {
            args.add("--server");
        }
        if (this == ANIMATE_SERVER || this == SERVER) {
            args.addAll(List.of("--port", 0));
        }
        return args;
    }

    /** What is given as the picture for it to be that file. */
    private Path picture(Path file) {
        String name = file.getFileName().toString();
        return isFilm() ? file.resolveSibling(name.replace(FRAME, "%04d")) : file;
    }

    private void add(List<Object> args, String output, Path file) {
        if (output.equals("--aov")) {
            String name = file.getFileName().toString().replace(".depth.png", ".png");
            args.set(args.indexOf("-o") + 1, picture(file.resolveSibling(name)));
            args.addAll(List.of("--aov", "depth"));
        } else if (output.equals("OUT.json")) {
            args.add(file);
        } else {
            args.addAll(List.of(output, output.equals("-o") ? picture(file) : file));
            // Of both only one is of any method: names are looked at first.
            if (output.startsWith("--dump") && !args.contains("--method")) {
                args.addAll(List.of("--method", output.equals("--dump-clusters") ? "cluster" : "metropolis"));
            }
        }
    }
}

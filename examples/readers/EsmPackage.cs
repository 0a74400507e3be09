// Reads a model package of the Elastodynamic Shape Modeler, and moves it: by docs/model-package.md alone.
//
// One file to copy, for C# 6 or later and any .NET, Mono or Unity, without other libraries. What is read has the names of
// the specification:
//
//     var package = EsmPackage.Read("liver.glb");
//     float[] lengths = package.Floats("springs", "restLength");          // m
//     var motion = new EsmMotion(package);
//     motion.Forces[12] = new[] {0, 0, -1.0};                             // N, by node
//     motion.Step(1e-4);                                                  // s
//     double[] places = motion.Positions;                                 // x, y, z of every node, m
//     double[] vertices = package.Carried(motion.Positions);              // x, y, z of every drawn vertex, m
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;

/// <summary>What is wrong with a package and what to do, in one line.</summary>
public sealed class EsmPackageException : Exception {
    public EsmPackageException(string problem) : base(problem) {}

    internal static void Need(bool condition, string problem, string remedy = "export the package again") {
        if (!condition) throw new EsmPackageException(problem + "; " + remedy);
    }
}

/// <summary>What a package holds. Groups that it lacks have no arrays.</summary>
public sealed class EsmPackage {
    private const int NewestVersion = 9, FloatType = 5126, UnsignedType = 5125;
    private const double Largest = 1e30;
    private const string NewerReader = "take a newer reader";

    public string Name { get; private set; }
    public int Version { get; private set; }
    /// <summary>Beyond this lengthening, relative to the rest length, springs have another constant; infinite: linear.</summary>
    public double StiffeningStrain { get; private set; }
    /// <summary>How many times their own that constant is.</summary>
    public double StiffeningFactor { get; private set; }
    /// <summary>The extension's JSON: objects are dictionaries, arrays lists, numbers double.</summary>
    public Dictionary<string, object> Json { get; private set; }
    /// <summary>Of each primitive: POSITION, NORMAL, TEXCOORD_0, TANGENT, indices, vertexNodes, vertices, triangles where it has them.</summary>
    public List<Dictionary<string, Array>> Drawn { get; private set; }
    /// <summary>As they lie in the file, PNG or JPEG, by their places in glTF's images.</summary>
    public List<byte[]> Pictures { get; private set; }
    /// <summary>Parts of the simulated surface, and how stiff the fluid in them is, Pa.</summary>
    public List<KeyValuePair<int, double>> Fillings { get; private set; }
    /// <summary>Parts, and what else presses on them from within: rows of s and Pa.</summary>
    public List<KeyValuePair<int, List<double[]>>> Pressures { get; private set; }

    private readonly Dictionary<string, Array> m_arrays = new Dictionary<string, Array>();
    private Dictionary<string, object> m_gltf;
    private byte[] m_text = new byte[0], m_binary = new byte[0];

    // group, key, what it is counted by, numbers for each of these, type of the accessor, and what a number may be
    private static readonly string[][] s_rows = new[] {
        "nodes restPosition nodes.count 3 VEC3 number", "nodes mass nodes.count 1 SCALAR mass",
        "nodes springConstant nodes.count 1 SCALAR amount", "nodes viscosity nodes.count 1 SCALAR amount",
        "springs nodes springs.count 2 SCALAR node", "springs restLength springs.count 1 SCALAR amount",
        "springs springConstant springs.count 1 SCALAR amount", "springs viscosity springs.count 1 SCALAR amount",
        "tethers nodes tethers.count 1 SCALAR node", "tethers springConstant tethers.count 1 SCALAR amount",
        "tethers viscosity tethers.count 1 SCALAR amount", "fixedNodes nodes fixedNodes.count 1 SCALAR node",
        "surface restPosition surface.vertexCount 3 VEC3 number", "surface vertexNodes surface.vertexCount 1 SCALAR node",
        "surface triangles surface.triangleCount 3 SCALAR vertex", "hinges nodes hinges.count 4 SCALAR node",
        "hinges stiffness hinges.count 1 SCALAR amount", "hinges viscosity hinges.count 1 SCALAR amount",
        "binding triangles binding.triangleCount 3 SCALAR node", "binding lines binding.lineCount 2 SCALAR node",
        "sheet springShares springs.count 1 SCALAR positive", "sheet nodeShares nodes.count 1 SCALAR positive",
        "lattice tetrahedra lattice.tetrahedronCount 4 SCALAR node", "lattice springShares springs.count 1 SCALAR positive",
        "lattice triangles lattice.triangleCount 3 SCALAR node"}.Select(row => row.Split(' ')).ToArray();
    private static readonly string[][] s_attributes = {
        new[] {"POSITION", "VEC3"}, new[] {"NORMAL", "VEC3"}, new[] {"TEXCOORD_0", "VEC2"}, new[] {"TANGENT", "VEC4"}};
    private static readonly string[] s_always = {"nodes", "springs", "tethers", "fixedNodes", "surface"};

    /// <summary>Throws EsmPackageException for what is damaged, no package or of a newer version, IOException without a file.</summary>
    public static EsmPackage Read(string path) {
        var package = new EsmPackage();
        try {
            package.ReadContainer(File.ReadAllBytes(path));
            package.ReadModel();
        } catch (Exception reason) when (!(reason is EsmPackageException || reason is IOException || reason is UnauthorizedAccessException)) {
            throw new EsmPackageException("is damaged: " + reason.Message.Split('\n')[0].Trim() + "; export the package again");
        }
        return package;
    }

    public bool Has(string group) { return Json.ContainsKey(group); }
    /// <summary>Flat, by group and key; empty where there is none.</summary>
    public float[] Floats(string group, string key) { return Found(group, key) as float[] ?? new float[0]; }
    public uint[] Indices(string group, string key) { return Found(group, key) as uint[] ?? new uint[0]; }
    public int NodeCount { get { return Floats("nodes", "mass").Length; } }

    private Array Found(string group, string key) {
        Array array;
        return m_arrays.TryGetValue(group + "." + key, out array) ? array : null;
    }

    private void ReadContainer(byte[] file) {
        EsmPackageException.Need(file.Length >= 20 && Word(file, 0) == 0x46546C67, "is no binary glTF file (.glb)", "choose a package");
        EsmPackageException.Need(Word(file, 4) == 2, "is glTF of another version than 2");
        EsmPackageException.Need(Word(file, 8) == file.Length, "is cut off or damaged: its header speaks of another length");
        for (long place = 12; place + 8 <= file.Length;) {
            long size = Word(file, place), kind = Word(file, place + 4), begin = place + 8;
            EsmPackageException.Need(begin + size <= file.Length, "is damaged: a part reaches beyond its end");
            if (m_gltf == null) {
                EsmPackageException.Need(kind == 0x4E4F534A, "is damaged: its first part is not JSON");
                m_text = new byte[size];
                Buffer.BlockCopy(file, (int)begin, m_text, 0, (int)size);
                m_gltf = new EsmJson(new UTF8Encoding(false, true).GetString(m_text)).Object();
            } else if (kind == 0x004E4942 && m_binary.Length == 0) {
                m_binary = new byte[size];
                Buffer.BlockCopy(file, (int)begin, m_binary, 0, (int)size);
            }
            place = begin + size;
        }
        EsmPackageException.Need(m_gltf != null, "is damaged: it has no JSON");
    }

    private static uint Word(byte[] file, long place) {
        return (uint)(file[place] | file[place + 1] << 8 | file[place + 2] << 16 | file[place + 3] << 24);
    }

    private void ReadModel() {
        object extensions, extension;
        var all = m_gltf.TryGetValue("extensions", out extensions) ? extensions as Dictionary<string, object> : null;
        Json = all != null && all.TryGetValue("ESM_spring_mass", out extension) ? extension as Dictionary<string, object> : null;
        EsmPackageException.Need(Json != null, "is glTF, but no model package: it has no ESM_spring_mass", "export the organ as a model package");
        Version = CountAt(Json, "version", "version");
        EsmPackageException.Need(Version >= 1, "says no version of its model");
        EsmPackageException.Need(Version <= NewestVersion,
                                 "is of version " + Version + ", newer than this reader, which knows up to " + NewestVersion, NewerReader);
        EsmPackageException.Need(At<string>(Json, "damping", "damping") == "isotropic", "damps in a way that this reader does not know", NewerReader);
        if (Json.ContainsKey("checksums")) CheckSums(Places(Json["checksums"], At<List<object>>(m_gltf, "bufferViews", "bufferViews").Count));
        Name = At<string>(Json, "name", "name");
        foreach (string group in s_always)
            EsmPackageException.Need(Json.ContainsKey(group), "has no " + group);
        foreach (string[] row in s_rows)
            if (Json.ContainsKey(row[0])) m_arrays[row[0] + "." + row[1]] = ReadArray(row);
        ReadStiffening();
        ReadBinding();
        ReadDrawn();
        ReadPictures();
        ReadFillings();
        ReadPressures();
        CheckModel();
    }

    private static readonly Dictionary<Type, string> s_kinds = new Dictionary<Type, string> {
        {typeof(string), "text"}, {typeof(double), "number"}, {typeof(List<object>), "list"}, {typeof(Dictionary<string, object>), "object"}};

    /// <summary>Of an object what there is by a key, which must be of that kind.</summary>
    private static T At<T>(Dictionary<string, object> holder, string key, string name) {
        object value;
        EsmPackageException.Need(holder.TryGetValue(key, out value) && value is T, "has no " + s_kinds[typeof(T)] + " at " + name);
        return (T)value;
    }
    private Dictionary<string, object> Group(string name) { return At<Dictionary<string, object>>(Json, name, name); }

    private static List<Dictionary<string, object>> Objects(Dictionary<string, object> holder, string key) {
        var found = At<List<object>>(holder, key, key).Select(item => item as Dictionary<string, object>).ToList();
        EsmPackageException.Need(!found.Contains(null), "has no list of objects at " + key);
        return found;
    }

    private static bool IsCount(object value) {
        return value is double && (double)value >= 0 && (double)value <= int.MaxValue && (double)value == Math.Floor((double)value);
    }
    private static int CountAt(Dictionary<string, object> holder, string key, string name) {
        object value;
        EsmPackageException.Need(holder.TryGetValue(key, out value) && IsCount(value), "has no count at " + name);
        return (int)(double)value;
    }
    private static int OffsetOf(Dictionary<string, object> holder, string name) {
        return holder.ContainsKey("byteOffset") ? CountAt(holder, "byteOffset", name + "/byteOffset") : 0;
    }
    private int CountOf(string name) {
        string[] parts = name.Split('.');
        return CountAt(Group(parts[0]), parts[1], name);
    }

    private Dictionary<string, object> Element(string kind, object place) {
        var list = At<List<object>>(m_gltf, kind, kind);
        EsmPackageException.Need(IsCount(place), "names a place in " + kind + " that is none");
        var found = (double)place < list.Count ? list[(int)(double)place] as Dictionary<string, object> : null;
        EsmPackageException.Need(found != null, "has nothing at " + kind + "/" + place);
        return found;
    }
    private static object Place(Dictionary<string, object> holder, string key) {
        object place;
        return holder.TryGetValue(key, out place) ? place : null;
    }

    /// <summary>Where a view begins, and how long it is.</summary>
    private int[] View(object place) {
        Dictionary<string, object> view = Element("bufferViews", place);
        string name = "bufferViews/" + place;
        long offset = OffsetOf(view, name), size = CountAt(view, "byteLength", name + "/byteLength");
        EsmPackageException.Need(!view.ContainsKey("byteStride"), name + " should have no byteStride");
        EsmPackageException.Need(CountAt(view, "buffer", name + "/buffer") == 0 && offset + size <= m_binary.Length,
                                 "is damaged: " + name + " reaches beyond the file's binary data");
        return new[] {(int)offset, (int)size};
    }

    /// <summary>Of an accessor. Count: how many elements it should have; below 0: any.</summary>
    private Array Numbers(object place, string type, long count) {
        Dictionary<string, object> accessor = Element("accessors", place);
        string name = "accessors/" + place;
        int found = CountAt(accessor, "count", name + "/count"), kind = CountAt(accessor, "componentType", name + "/componentType");
        int offset = OffsetOf(accessor, name);
        EsmPackageException.Need(At<string>(accessor, "type", name + "/type") == type, name + " should be of type " + type);
        EsmPackageException.Need(count < 0 || found == count, name + " should have " + count + " elements, but has " + found);
        bool isPlain = !accessor.ContainsKey("sparse") && !true.Equals(Place(accessor, "normalized"));
        EsmPackageException.Need((kind == FloatType || kind == UnsignedType) && isPlain, name + " is neither of float nor of unsigned int");
        int[] view = View(Place(accessor, "bufferView"));
        long numbers = (long)found * (type == "SCALAR" ? 1 : type[3] - '0');
        EsmPackageException.Need(offset % 4 == 0 && offset + 4 * numbers <= view[1], "is damaged: " + name + " reaches beyond its bufferView");
        Array values = kind == FloatType ? (Array)new float[numbers] : new uint[numbers];
        Buffer.BlockCopy(m_binary, view[0] + offset, values, 0, (int)(4 * numbers));
        return values;
    }
    private uint[] Places(object place, long count) {
        var places = Numbers(place, "SCALAR", count) as uint[];
        EsmPackageException.Need(places != null, "accessors/" + place + " should be of unsigned int");
        return places;
    }

    /// <summary>That no bit has flipped. In the place of the sums' own view, the last, stands that of the JSON.</summary>
    private void CheckSums(uint[] sums) {
        EsmPackageException.Need(sums.Length > 0, "has no bufferViews");
        long summed = Enumerable.Range(0, sums.Length).Sum(i => (long)View((double)i)[1]);
        EsmPackageException.Need(summed <= m_binary.Length, "bufferViews overlap, which check sums do not allow");
        EsmPackageException.Need(Crc32(m_text, 0, m_text.Length) == sums[sums.Length - 1],
                                 "is damaged: its JSON does not have the check sum that it should");
        for (int i = 0; i + 1 < sums.Length; ++i) {
            int[] view = View((double)i);
            EsmPackageException.Need(Crc32(m_binary, view[0], view[1]) == sums[i],
                                     "is damaged: bufferViews/" + i + " does not have the check sum that it should");
        }
    }

    private static readonly uint[] s_crcs = Enumerable.Range(0, 256).Select(start => {
        uint entry = (uint)start;
        for (int bit = 0; bit < 8; ++bit)
            entry = (entry & 1) != 0 ? entry >> 1 ^ 0xEDB88320 : entry >> 1;
        return entry;
    }).ToArray();

    /// <summary>As zlib and PNG have it.</summary>
    private static uint Crc32(byte[] bytes, int begin, int size) {
        uint sum = 0xFFFFFFFF;
        for (int i = begin; i < begin + size; ++i)
            sum = s_crcs[(sum ^ bytes[i]) & 255] ^ sum >> 8;
        return ~sum;
    }

    private Array ReadArray(string[] row) {
        long count = CountOf(row[2]), each = int.Parse(row[3]), size = row[4] == "VEC3" ? 3 : 1;
        bool isIndex = row[5] == "node" || row[5] == "vertex";
        if (count == 0) return isIndex ? (Array)new uint[0] : new float[0];
        Array values = Numbers(Place(Group(row[0]), row[1]), row[4], count * each / size);
        if (isIndex) return CheckIndices(values as uint[], row[5], row[0] + "." + row[1]);
        return CheckFloats(values as float[], row[5], row[0] + "." + row[1]);
    }

    private static long LargestOf(uint[] indices) { return indices.Length == 0 ? -1L : indices.Max(); }

    private uint[] CheckIndices(uint[] indices, string of, string name) {
        EsmPackageException.Need(indices != null, name + " should be of unsigned int");
        long largest = LargestOf(indices);
        long limit = CountOf(of == "node" ? "nodes.count" : of == "vertex" ? "surface.vertexCount" : "surface.triangleCount");
        EsmPackageException.Need(largest < limit, name + " names " + of + " " + largest + ", but there are " + limit + ", counted from 0");
        return indices;
    }

    private static float[] CheckFloats(float[] values, string allowed, string name) {
        EsmPackageException.Need(values != null, name + " should be of float");
        double least = allowed == "number" ? -Largest : allowed == "mass" ? 1 / Largest : allowed == "positive" ? double.Epsilon : 0;
        int bad = Array.FindIndex(values, value => !(value >= least && value <= Largest));
        if (bad < 0) return values;
        string range = allowed == "number" ? "from -1e30"
                     : allowed == "mass" ? "from 1e-30" : allowed == "positive" ? "above 0," : "from 0";
        string found = values[bad].ToString("G6", CultureInfo.InvariantCulture);
        string problem = ": number " + bad + " is " + found + ", but must be " + range + " to 1e30; export the package again";
        throw new EsmPackageException(name + problem);
    }

    private void ReadStiffening() {
        StiffeningStrain = double.PositiveInfinity;
        StiffeningFactor = 1;
        if (!Json.ContainsKey("stiffening")) return;
        Dictionary<string, object> law = Group("stiffening");
        StiffeningStrain = At<double>(law, "strain", "stiffening.strain");
        StiffeningFactor = At<double>(law, "factor", "stiffening.factor");
        EsmPackageException.Need(StiffeningStrain > 0 && StiffeningFactor > 0 && StiffeningStrain <= Largest && StiffeningFactor <= Largest,
                                 "stiffening should have a strain and a factor above 0, up to 1e30");
    }

    private void ReadBinding() {
        if (!Has("binding")) return;
        Dictionary<string, object> binding = Group("binding");
        int vertices = CountOf("surface.vertexCount");
        bool hasStarts = binding.ContainsKey("starts");
        uint[] starts = hasStarts ? Places(binding["starts"], vertices + 1L)
                                  : Enumerable.Range(0, vertices + 1).Select(i => (uint)(3 * i)).ToArray();
        bool rise = starts[0] == 0;
        for (int i = 0; i < vertices; ++i)
            rise &= starts[i] < starts[i + 1];
        EsmPackageException.Need(rise, "binding.starts do not rise from 0");
        long all = starts[vertices];
        object places = Place(binding, "shares");
        Array numbers = hasStarts ? Numbers(places, "SCALAR", all) : Numbers(places, "VEC3", vertices);
        float[] shares = CheckFloats(numbers as float[], "number", "binding.shares");
        uint[] nodes = CheckIndices(Places(Place(binding, "nodes"), all), "node", "binding.nodes");
        for (int i = 0; i < vertices; ++i) {
            double sum = 0;
            bool good = true;
            for (uint place = starts[i]; place < starts[i + 1]; ++place) {
                sum += shares[place];
                good &= Math.Abs(shares[place]) <= 4;
            }
            EsmPackageException.Need(good && Math.Abs(sum - 1) <= 1e-6,
                                     "binding.shares: those in vertex " + i + " should be from -4 to 4 and make 1");
        }
        m_arrays["binding.starts"] = starts;
        m_arrays["binding.nodes"] = nodes;
        m_arrays["binding.shares"] = shares;
    }

    private void ReadDrawn() {
        Drawn = new List<Dictionary<string, Array>>();
        foreach (Dictionary<string, object> entry in Objects(Json, "drawn")) {
            List<Dictionary<string, object>> primitives = Objects(Element("meshes", Place(entry, "mesh")), "primitives");
            int place = CountAt(entry, "primitive", "drawn.primitive");
            EsmPackageException.Need(place < primitives.Count, "drawn names primitive " + place + ", which is not there");
            Drawn.Add(Primitive(entry, primitives[place], "primitive " + place + " of drawn"));
        }
    }

    private Dictionary<string, Array> Primitive(Dictionary<string, object> entry, Dictionary<string, object> primitive, string name) {
        var attributes = At<Dictionary<string, object>>(primitive, "attributes", "attributes of " + name);
        EsmPackageException.Need(attributes.ContainsKey("POSITION"), name + " has no POSITION");
        EsmPackageException.Need(entry.ContainsKey("vertexNodes"), "has no drawn.vertexNodes");
        var part = new Dictionary<string, Array>();
        foreach (string[] kind in s_attributes)
            if (attributes.ContainsKey(kind[0]))
                part[kind[0]] = CheckFloats(Numbers(attributes[kind[0]], kind[1], -1) as float[], "number", "drawn." + kind[0]);
        int count = part["POSITION"].Length / 3;
        foreach (string[] kind in new[] {new[] {"vertexNodes", "node"}, new[] {"vertices", "vertex"}})
            if (entry.ContainsKey(kind[0])) part[kind[0]] = CheckIndices(Places(entry[kind[0]], count), kind[1], "drawn." + kind[0]);
        uint[] indices = primitive.ContainsKey("indices") ? Places(primitive["indices"], -1) : new uint[0];
        long largest = LargestOf(indices);
        EsmPackageException.Need(largest < count, name + " has index " + largest + ", but " + count + " vertices, counted from 0");
        if (primitive.ContainsKey("indices")) part["indices"] = indices;
        if (!entry.ContainsKey("triangles")) return part;
        part["triangles"] = CheckIndices(Places(entry["triangles"], -1), "triangle", "drawn.triangles");
        EsmPackageException.Need(indices.Length == 3L * part["triangles"].Length, "drawn.triangles are not as many as " + name + " draws");
        return part;
    }

    private void ReadPictures() {
        Pictures = new List<byte[]>();
        if (!m_gltf.ContainsKey("images")) return;
        foreach (Dictionary<string, object> image in Objects(m_gltf, "images")) {
            int[] view = View(Place(image, "bufferView"));
            var bytes = new byte[view[1]];
            Buffer.BlockCopy(m_binary, view[0], bytes, 0, view[1]);
            Pictures.Add(bytes);
        }
    }

    private void ReadFillings() {
        Fillings = new List<KeyValuePair<int, double>>();
        foreach (Dictionary<string, object> filling in OfParts("fillings")) {
            double stiffness = At<double>(filling, "stiffness", "fillings.stiffness");
            EsmPackageException.Need(stiffness > 0 && stiffness <= Largest,
                                     "fillings: stiffness " + Fillings.Count + " should be above 0, up to 1e30 Pa");
            Fillings.Add(new KeyValuePair<int, double>(CountAt(filling, "part", "fillings.part"), stiffness));
        }
    }

    private void ReadPressures() {
        Pressures = new List<KeyValuePair<int, List<double[]>>>();
        foreach (Dictionary<string, object> pressure in OfParts("pressures")) {
            List<double[]> path = At<List<object>>(pressure, "path", "pressures.path").Select(Row).ToList();
            bool good = path.Count > 0 && !path.Contains(null);
            for (int i = 1; good && i < path.Count; ++i)
                good = path[i - 1][0] < path[i][0];
            EsmPackageException.Need(good, "pressures: a path should be a list of [s, Pa], the times rising");
            Pressures.Add(new KeyValuePair<int, List<double[]>>(CountAt(pressure, "part", "pressures.part"), path));
        }
    }

    /// <summary>Two numbers; null where it is something else.</summary>
    private static double[] Row(object found) {
        var row = found as List<object>;
        bool good = row != null && row.Count == 2 && row.All(number => number is double && Math.Abs((double)number) <= Largest);
        return good ? new[] {(double)row[0], (double)row[1]} : null;
    }

    /// <summary>A list of objects that name a part each, and no part twice.</summary>
    private List<Dictionary<string, object>> OfParts(string name) {
        if (!Has(name)) return new List<Dictionary<string, object>>();
        List<Dictionary<string, object>> found = Objects(Json, name);
        int different = found.Select(ofPart => CountAt(ofPart, "part", name + ".part")).Distinct().Count();
        EsmPackageException.Need(different == found.Count, name + " name a part twice");
        return found;
    }

    private void CheckModel() {
        EsmPackageException.Need(NodeCount > 0, "has no nodes");
        CheckDifferent("springs", "nodes", 2);
        CheckDifferent("hinges", "nodes", 4);
        CheckDifferent("binding", "lines", 2);
        CheckDifferent("lattice", "tetrahedra", 4);
        uint[] fixedNodes = Indices("fixedNodes", "nodes");
        for (int i = 1; i < fixedNodes.Length; ++i)
            EsmPackageException.Need(fixedNodes[i - 1] < fixedNodes[i], "fixedNodes.nodes do not rise");
        EsmPackageException.Need(Version >= 6 || (AreMeans("springConstant") && AreMeans("viscosity")),
                                 "its springs are not the mean of their nodes");
    }

    /// <summary>That each row of nodes names none twice.</summary>
    private void CheckDifferent(string group, string key, int size) {
        uint[] nodes = Indices(group, key);
        for (int i = 0; i < nodes.Length; ++i)
            for (int k = i - i % size; k < i; ++k)
                if (nodes[k] == nodes[i])
                    EsmPackageException.Need(false, group + "." + key + ": the nodes of number " + i / size + " should differ");
    }

    private double[] Means(string key) {
        float[] at = Floats("nodes", key);
        uint[] ends = Indices("springs", "nodes");
        return Enumerable.Range(0, ends.Length / 2).Select(i => ((double)at[ends[2 * i]] + at[ends[2 * i + 1]]) / 2).ToArray();
    }
    private bool AreMeans(string key) {
        float[] at = Floats("nodes", key), own = Floats("springs", key);
        uint[] ends = Indices("springs", "nodes");
        double[] means = Means(key);
        return Enumerable.Range(0, own.Length).All(i => Math.Abs(own[i] - means[i]) <= 1e-6 * Math.Max(at[ends[2 * i]], at[ends[2 * i + 1]]));
    }

    /// <summary>Of springs. Where all are the mean of their nodes', that mean, not rounded as the file has it.</summary>
    public double[] SpringValues(string key) {
        bool areRounded = AreMeans("springConstant") && AreMeans("viscosity");
        return areRounded ? Means(key) : Floats("springs", key).Select(value => (double)value).ToArray();
    }

    /// <summary>Three nodes each: what instruments touch, and fluid fills.</summary>
    public uint[] SimulatedTriangles() {
        if (Has("lattice")) return Indices("lattice", "triangles");
        if (Has("binding")) return Indices("binding", "triangles");
        uint[] nodes = Indices("surface", "vertexNodes"), corners = Indices("surface", "triangles");
        var triangles = new List<uint>();
        for (int i = 0; i < corners.Length; i += 3) {
            uint a = nodes[corners[i]], b = nodes[corners[i + 1]], c = nodes[corners[i + 2]];
            if (a != b && b != c && c != a) triangles.AddRange(new[] {a, b, c});
        }
        return triangles.ToArray();
    }

    /// <summary>x, y, z of every vertex of the surface, m, where nodes at these positions carry it.</summary>
    public double[] Carried(double[] positions) {
        float[] rest = Floats("nodes", "restPosition"), vertices = Floats("surface", "restPosition");
        var places = vertices.Select(number => (double)number).ToArray();
        if (!Has("binding")) {
            uint[] carriers = Indices("surface", "vertexNodes");
            for (int i = 0; i < places.Length; ++i)
                places[i] += positions[3 * carriers[i / 3] + i % 3] - rest[3 * carriers[i / 3] + i % 3];
            return places;
        }
        uint[] starts = Indices("binding", "starts"), nodes = Indices("binding", "nodes");
        float[] shares = Floats("binding", "shares");
        double[][] turns = Turns(positions);
        for (int vertex = 0; vertex + 1 < starts.Length; ++vertex)
            for (uint k = starts[vertex]; k < starts[vertex + 1]; ++k) {
                EsmVector p0 = EsmVector.At(rest, nodes[k]), arm = EsmVector.At(vertices, (uint)vertex) - p0;
                double[] turn = turns[nodes[k]];
                EsmVector turned = turn == null ? arm : EsmVector.Times(turn, arm);
                (shares[k] * (EsmVector.At(positions, nodes[k]) - p0 + turned - arm)).AddTo(places, (uint)vertex);
            }
        return places;
    }

    /// <summary>For every node the matrix G of the specification, by rows; null where it is 1.</summary>
    private double[][] Turns(double[] positions) {
        float[] rest = Floats("nodes", "restPosition");
        var sums = new double[NodeCount][];
        var weights = new double[NodeCount];
        Action<uint, double[], double> add = (node, matrix, weight) => {
            weights[node] += weight;
            sums[node] = sums[node] == null ? matrix : sums[node].Zip(matrix, (a, b) => a + b).ToArray();
        };
        uint[] corners = Indices("binding", "triangles"), lines = Indices("binding", "lines");
        for (int i = 0; i < corners.Length; i += 3) {
            EsmVector first = EsmVector.At(rest, corners[i]), now = EsmVector.At(positions, corners[i]);
            EsmVector a0 = EsmVector.At(rest, corners[i + 1]) - first, b0 = EsmVector.At(rest, corners[i + 2]) - first;
            EsmVector a = EsmVector.At(positions, corners[i + 1]) - now, b = EsmVector.At(positions, corners[i + 2]) - now;
            EsmVector n0 = EsmVector.Cross(a0, b0), n = EsmVector.Cross(a, b);
            double area = n0.Length, areaNow = n.Length;
            if (area == 0) continue;
            n0 = 1 / area * n0;
            n = (areaNow > 0 ? area / areaNow : 0) * n;
            double[] part = EsmVector.Outer(a, EsmVector.Cross(b0, n0));
            double[][] others = {EsmVector.Outer(b, EsmVector.Cross(n0, a0)), EsmVector.Outer(n, n0)};
            foreach (double[] other in others)
                part = part.Zip(other, (x, y) => x + y).ToArray();
            for (int corner = 0; corner < 3; ++corner)
                add(corners[i + corner], part, area);
        }
        for (int i = 0; i < lines.Length; i += 2) {
            double[] turn = EsmVector.SmallestRotation(EsmVector.At(rest, lines[i + 1]) - EsmVector.At(rest, lines[i]),
                                                       EsmVector.At(positions, lines[i + 1]) - EsmVector.At(positions, lines[i]));
            add(lines[i], turn, 1);
            add(lines[i + 1], turn, 1);
        }
        return sums.Select((sum, node) => sum == null ? null : sum.Select(x => x / weights[node]).ToArray()).ToArray();
    }
}

/// <summary>Euler, semi-implicit, for light tissue and short steps; Split, which takes viscosity implicitly, for overdamped tissue
/// and not for parts that fluid fills.</summary>
public enum EsmIntegrator { Euler, Split }

/// <summary>A package that moves, from rest. Its pressures begin at time 0.</summary>
public sealed class EsmMotion {
    /// <summary>x, y, z of every node: m, and m/s.</summary>
    public double[] Positions { get; private set; }
    public double[] Velocities { get; private set; }
    public double Time { get; private set; }
    public EsmVector Gravity;                                                               // m/s²
    public readonly Dictionary<uint, double[]> Forces = new Dictionary<uint, double[]>();   // N, by node
    /// <summary>m, by node: the place at the step's end. Fixed nodes stay.</summary>
    public readonly Dictionary<uint, double[]> Led = new Dictionary<uint, double[]>();

    private readonly EsmPackage m_package;
    private readonly EsmIntegrator m_integrator;
    private readonly double[] m_constants, m_viscosities;
    private readonly float[] m_rest, m_masses, m_lengths;
    private readonly uint[] m_ends;
    private readonly HashSet<uint> m_fixed;
    private readonly List<EsmHinge> m_hinges = new List<EsmHinge>();
    private readonly List<EsmFluid> m_fluids;

    public EsmMotion(EsmPackage package, EsmIntegrator integrator = EsmIntegrator.Euler) {
        EsmPackageException.Need(integrator == EsmIntegrator.Euler || package.Fillings.Count == 0,
                                 "this reader steps parts that are filled with fluid by Euler alone", "take Euler");
        m_package = package;
        m_integrator = integrator;
        m_rest = package.Floats("nodes", "restPosition");
        m_masses = package.Floats("nodes", "mass");
        m_ends = package.Indices("springs", "nodes");
        m_lengths = package.Floats("springs", "restLength");
        m_constants = package.SpringValues("springConstant");
        m_viscosities = package.SpringValues("viscosity");
        m_fixed = new HashSet<uint>(package.Indices("fixedNodes", "nodes"));
        uint[] hinges = package.Indices("hinges", "nodes");
        for (int i = 0; i < hinges.Length; i += 4)
            m_hinges.Add(new EsmHinge(new[] {hinges[i], hinges[i + 1], hinges[i + 2], hinges[i + 3]}, package.Floats("hinges", "stiffness")[i / 4],
                                      package.Floats("hinges", "viscosity")[i / 4], m_rest));
        Reset();
        m_fluids = EsmFluid.Of(package, Positions);
    }

    public void Reset() {
        Positions = m_rest.Select(number => (double)number).ToArray();
        Velocities = new double[Positions.Length];
        Time = 0;
    }

    /// <summary>Moves on by so many seconds.</summary>
    public void Step(double h) {
        var led = Led.Where(place => !m_fixed.Contains(place.Key)).ToList();
        foreach (var place in led)
            for (int axis = 0; axis < 3; ++axis)
                Velocities[3 * place.Key + axis] = (place.Value[axis] - Positions[3 * place.Key + axis]) / h;
        var isGiven = new bool[m_masses.Length];
        foreach (uint node in m_fixed.Concat(led.Select(place => place.Key)))
            isGiven[node] = true;
        if (m_integrator == EsmIntegrator.Euler)
            Accelerate(h, isGiven);
        else
            Velocities = Solved(h, isGiven);
        for (int i = 0; i < Positions.Length; ++i)
            Positions[i] += h * Velocities[i];
        foreach (var place in led)
            Array.Copy(place.Value, 0, Positions, 3 * place.Key, 3);
        Time += h;
    }

    private void Accelerate(double h, bool[] isGiven) {
        double[] pull = AllForces(Time, Time + h), resistance = Resistance(Velocities);
        for (int i = 0; i < pull.Length; ++i)
            if (!isGiven[i / 3]) Velocities[i] += h * (pull[i] - resistance[i]) / m_masses[i / 3];
    }

    /// <summary>(M + h·D)·v, with 0 for nodes whose velocity is given.</summary>
    private double[] Times(double h, double[] v, bool[] isGiven) {
        double[] product = Resistance(v);
        for (int i = 0; i < v.Length; ++i)
            product[i] = isGiven[i / 3] ? 0 : m_masses[i / 3] * v[i] + h * product[i];
        return product;
    }
    private double Product(double[] x, double[] y) {
        return Enumerable.Range(0, x.Length).Sum(i => x[i] * y[i] / m_masses[i / 3]);
    }

    /// <summary>Velocities by (M + h·D)·v = M·v + h·f, those that are given left as they are: conjugate gradients, from the last ones.</summary>
    private double[] Solved(double h, bool[] isGiven) {
        double[] v = (double[])Velocities.Clone(), pull = AllForces(Time + h, Time + h), taken = Times(h, v, isGiven);
        var right = new double[v.Length];
        for (int i = 0; i < v.Length; ++i)
            right[i] = isGiven[i / 3] ? 0 : m_masses[i / 3] * v[i] + h * pull[i];
        double[] left = right.Zip(taken, (a, b) => a - b).ToArray(), way = left.Select((a, i) => a / m_masses[i / 3]).ToArray();
        double size = Product(left, left), wanted = 1e-30 * Math.Max(size, Product(right, right));
        for (int round = 0; round < 10 * v.Length && !(size <= wanted); ++round) {
            double[] change = Times(h, way, isGiven);
            double share = size / way.Zip(change, (a, b) => a * b).Sum(), before = size;
            for (int i = 0; i < v.Length; ++i) {
                v[i] += share * way[i];
                left[i] -= share * change[i];
            }
            size = Product(left, left);
            for (int i = 0; i < v.Length; ++i)
                way[i] = left[i] / m_masses[i / 3] + size / before * way[i];
        }
        EsmPackageException.Need(size <= wanted && !double.IsInfinity(wanted), "a step of split did not converge", "take a shorter step");
        return v;
    }

    /// <summary>N: all but what viscosity does, with the mean of the pressures at two times, s.</summary>
    private double[] AllForces(double begin, double end) {
        var forces = new double[Positions.Length];
        for (int i = 0; i < m_lengths.Length; ++i)
            AddSpring(i, forces);
        uint[] tethered = m_package.Indices("tethers", "nodes");
        float[] constants = m_package.Floats("tethers", "springConstant");
        for (int i = 0; i < tethered.Length; ++i)
            (constants[i] * (EsmVector.At(m_rest, tethered[i]) - EsmVector.At(Positions, tethered[i]))).AddTo(forces, tethered[i]);
        foreach (EsmHinge hinge in m_hinges)
            hinge.AddForces(Positions, forces);
        foreach (EsmFluid fluid in m_fluids)
            fluid.AddForces(Positions, begin, end, forces);
        foreach (var force in Forces)
            new EsmVector(force.Value[0], force.Value[1], force.Value[2]).AddTo(forces, force.Key);
        for (uint node = 0; node < m_masses.Length; ++node)
            (m_masses[node] * Gravity).AddTo(forces, node);
        return forces;
    }

    private void AddSpring(int spring, double[] forces) {
        uint first = m_ends[2 * spring], second = m_ends[2 * spring + 1];
        EsmVector between = EsmVector.At(Positions, first) - EsmVector.At(Positions, second);
        double length = between.Length, rest = m_lengths[spring], pull = 0, stretched = (1 + m_package.StiffeningStrain) * rest;
        if (length > 0) pull = m_constants[spring] * (rest / length - 1);
        if (length > stretched) pull -= (m_package.StiffeningFactor - 1) * m_constants[spring] * (1 - stretched / length);
        EsmVector force = pull * between;
        force.AddTo(forces, first);
        (-1 * force).AddTo(forces, second);
    }

    /// <summary>N against velocities, m/s: the constant matrix of all viscosities times them.</summary>
    private double[] Resistance(double[] v) {
        var forces = new double[v.Length];
        for (int i = 0; i < m_viscosities.Length; ++i) {
            EsmVector part = m_viscosities[i] * (EsmVector.At(v, m_ends[2 * i]) - EsmVector.At(v, m_ends[2 * i + 1]));
            part.AddTo(forces, m_ends[2 * i]);
            (-1 * part).AddTo(forces, m_ends[2 * i + 1]);
        }
        uint[] tethered = m_package.Indices("tethers", "nodes");
        float[] viscosities = m_package.Floats("tethers", "viscosity");
        for (int i = 0; i < tethered.Length; ++i)
            (viscosities[i] * EsmVector.At(v, tethered[i])).AddTo(forces, tethered[i]);
        foreach (EsmHinge hinge in m_hinges)
            hinge.AddResistance(v, forces);
        return forces;
    }
}

/// <summary>What presses from within on a closed part of the surface: a fluid by its stiffness, and a pressure with a path in time.</summary>
internal sealed class EsmFluid {
    private readonly List<uint> m_wall; // three nodes each, facing outwards
    private readonly double m_enclosed, m_stiffness;
    private readonly List<double[]> m_path;

    private EsmFluid(List<List<uint>> parts, int part, double stiffness, List<double[]> path, double[] rest) {
        EsmPackageException.Need(part < parts.Count, "fills part " + part + " of " + parts.Count + ", counted from 0");
        m_wall = parts[part];
        EsmPackageException.Need(IsClosed(m_wall), "fills part " + part + ", which is open");
        m_stiffness = stiffness;
        m_path = path;
        m_enclosed = Volume(rest);
        EsmPackageException.Need(m_enclosed != 0, "fills part " + part + ", which encloses nothing");
        if (m_enclosed > 0) return;
        m_enclosed = -m_enclosed;
        m_wall = m_wall.ToList();
        for (int i = 0; i < m_wall.Count; i += 3)
            m_wall.Reverse(i, 3);
    }

    public static List<EsmFluid> Of(EsmPackage package, double[] rest) {
        List<List<uint>> parts = Parts(package.SimulatedTriangles());
        var constant = new List<double[]> {new double[] {0, 0}};
        var fluids = package.Fillings.Select(filling => new EsmFluid(parts, filling.Key, filling.Value, constant, rest));
        return fluids.Concat(package.Pressures.Select(pressure => new EsmFluid(parts, pressure.Key, 0, pressure.Value, rest))).ToList();
    }

    /// <summary>The connected parts, by their first triangles.</summary>
    private static List<List<uint>> Parts(uint[] triangles) {
        var leaders = triangles.Distinct().ToDictionary(node => node);
        Func<uint, uint> first = node => {
            while (leaders[node] != node)
                leaders[node] = node = leaders[leaders[node]];
            return node;
        };
        for (int i = 0; i < triangles.Length; ++i)
            leaders[first(triangles[i])] = first(triangles[i - i % 3]);
        var parts = new Dictionary<uint, List<uint>>();
        var inOrder = new List<List<uint>>();
        foreach (uint node in triangles) {
            uint leader = first(node);
            if (!parts.ContainsKey(leader)) inOrder.Add(parts[leader] = new List<uint>());
            parts[leader].Add(node);
        }
        return inOrder;
    }

    /// <summary>Whether each edge is run along as often one way as the other.</summary>
    private static bool IsClosed(List<uint> wall) {
        var turns = new Dictionary<ulong, int>();
        for (int i = 0; i < wall.Count; ++i) {
            ulong a = wall[i], b = wall[i % 3 == 2 ? i - 2 : i + 1], edge = Math.Min(a, b) << 32 | Math.Max(a, b);
            int before;
            turns.TryGetValue(edge, out before);
            turns[edge] = before + (a < b ? 1 : -1);
        }
        return turns.Values.All(turn => turn == 0);
    }

    /// <summary>m³. Measured from a corner, which keeps numbers small far from the origin.</summary>
    private double Volume(double[] positions) {
        EsmVector origin = EsmVector.At(positions, m_wall[0]);
        double sum = 0;
        for (int i = 0; i < m_wall.Count; i += 3) {
            EsmVector b = EsmVector.At(positions, m_wall[i + 1]) - origin, c = EsmVector.At(positions, m_wall[i + 2]) - origin;
            sum += EsmVector.Dot(EsmVector.At(positions, m_wall[i]) - origin, EsmVector.Cross(b, c));
        }
        return sum / 6;
    }

    /// <summary>Pa: even between the rows of the path, before and after them as at its ends.</summary>
    private double PressureAt(double time) {
        int next = m_path.FindIndex(row => time < row[0]);
        if (next < 0) return m_path[m_path.Count - 1][1];
        if (next == 0) return m_path[0][1];
        double[] from = m_path[next - 1], to = m_path[next];
        return from[1] + (time - from[0]) / (to[0] - from[0]) * (to[1] - from[1]);
    }

    public void AddForces(double[] positions, double begin, double end, double[] forces) {
        double pressure = m_stiffness * (m_enclosed - Volume(positions)) / m_enclosed + (PressureAt(begin) + PressureAt(end)) / 2;
        for (int i = 0; i < m_wall.Count; i += 3) {
            EsmVector a = EsmVector.At(positions, m_wall[i]);
            EsmVector b = EsmVector.At(positions, m_wall[i + 1]) - a, c = EsmVector.At(positions, m_wall[i + 2]) - a;
            for (int corner = i; corner < i + 3; ++corner)
                (pressure / 6 * EsmVector.Cross(b, c)).AddTo(forces, m_wall[corner]);
        }
    }
}

/// <summary>Two triangles that resist being bent about their edge.</summary>
internal sealed class EsmHinge {
    private readonly uint[] m_nodes;
    private readonly double[] m_weights;
    private readonly double m_curvature, m_constant, m_damping;

    public EsmHinge(uint[] nodes, double stiffness, double viscosity, float[] rest) {
        EsmVector[] p = nodes.Select(node => EsmVector.At(rest, node)).ToArray();
        EsmVector u = p[1] - p[0], v = p[3] - p[2], r = p[2] - p[0], n = EsmVector.Cross(u, v);
        double squared = EsmVector.Dot(n, n);
        double along = EsmVector.Dot(EsmVector.Cross(r, v), n) / squared, across = EsmVector.Dot(EsmVector.Cross(r, u), n) / squared;
        m_nodes = nodes;
        m_weights = new[] {along - 1, -along, 1 - across, across};
        m_curvature = EsmVector.Dot(r, n) / squared;
        EsmVector t = EsmVector.Cross(1 / u.Length * u, r), opening = m_weights[2] * t + m_curvature * EsmVector.Cross(u, t);
        EsmPackageException.Need(squared > 0 && opening.Length > 0, "a hinge has a triangle without area");
        m_constant = stiffness / EsmVector.Dot(opening, opening);
        m_damping = viscosity / EsmVector.Dot(opening, opening);
    }

    private EsmVector Sum(double[] of) {
        EsmVector first = EsmVector.At(of, m_nodes[0]), sum = new EsmVector();
        for (int i = 1; i < 4; ++i)
            sum += m_weights[i] * (EsmVector.At(of, m_nodes[i]) - first);
        return sum;
    }

    public void AddForces(double[] positions, double[] forces) {
        EsmVector[] p = m_nodes.Select(node => EsmVector.At(positions, node)).ToArray();
        EsmVector u = p[1] - p[0], v = p[3] - p[2];
        EsmVector f = -m_constant * (Sum(positions) - m_curvature * EsmVector.Cross(u, v));
        EsmVector g = -m_curvature * EsmVector.Cross(v, f), h = -m_curvature * EsmVector.Cross(f, u);
        var parts = new[] {new EsmVector(), m_weights[1] * f + g, m_weights[2] * f - h, m_weights[3] * f + h};
        parts[0] = -1 * (parts[1] + parts[2] + parts[3]);
        for (int i = 0; i < 4; ++i)
            parts[i].AddTo(forces, m_nodes[i]);
    }

    public void AddResistance(double[] velocities, double[] forces) {
        EsmVector resistance = m_damping * Sum(velocities);
        for (int i = 0; i < 4; ++i)
            (m_weights[i] * resistance).AddTo(forces, m_nodes[i]);
    }
}

public struct EsmVector {
    public double X, Y, Z;

    public EsmVector(double x, double y, double z) { X = x; Y = y; Z = z; }
    public static EsmVector At(double[] values, uint place) { return new EsmVector(values[3 * place], values[3 * place + 1], values[3 * place + 2]); }
    public static EsmVector At(float[] values, uint place) { return new EsmVector(values[3 * place], values[3 * place + 1], values[3 * place + 2]); }
    public static EsmVector operator +(EsmVector a, EsmVector b) { return new EsmVector(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
    public static EsmVector operator -(EsmVector a, EsmVector b) { return new EsmVector(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
    public static EsmVector operator *(double number, EsmVector a) { return new EsmVector(number * a.X, number * a.Y, number * a.Z); }
    public static double Dot(EsmVector a, EsmVector b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }
    public static EsmVector Cross(EsmVector a, EsmVector b) {
        return new EsmVector(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);
    }
    public double Length { get { return Math.Sqrt(Dot(this, this)); } }

    public void AddTo(double[] values, uint place) {
        values[3 * place] += X;
        values[3 * place + 1] += Y;
        values[3 * place + 2] += Z;
    }

    /// <summary>Matrices are nine numbers, by rows.</summary>
    public static double[] Outer(EsmVector a, EsmVector b) {
        return new[] {a.X * b.X, a.X * b.Y, a.X * b.Z, a.Y * b.X, a.Y * b.Y, a.Y * b.Z, a.Z * b.X, a.Z * b.Y, a.Z * b.Z};
    }
    public static EsmVector Times(double[] m, EsmVector a) {
        return new EsmVector(m[0] * a.X + m[1] * a.Y + m[2] * a.Z, m[3] * a.X + m[4] * a.Y + m[5] * a.Z, m[6] * a.X + m[7] * a.Y + m[8] * a.Z);
    }

    /// <summary>Takes the direction of the one to that of the other.</summary>
    public static double[] SmallestRotation(EsmVector first, EsmVector second) {
        var unit = new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1};
        if (first.Length == 0 || second.Length == 0) return unit;
        EsmVector a = 1 / first.Length * first, b = 1 / second.Length * second, axis = Cross(a, b);
        double cosine = Dot(a, b);
        if (cosine <= -1 + 1e-12) return unit;
        double[] cross = {0, -axis.Z, axis.Y, axis.Z, 0, -axis.X, -axis.Y, axis.X, 0}, outer = Outer(axis, axis);
        for (int i = 0; i < 9; ++i)
            unit[i] += cross[i] + (outer[i] - (i % 4 == 0 ? Dot(axis, axis) : 0)) / (1 + cosine);
        return unit;
    }
}

/// <summary>What of JSON a package needs, read strictly.</summary>
internal sealed class EsmJson {
    private const int Deepest = 100;
    private readonly string m_text;
    private int m_place, m_depth;

    public EsmJson(string text) { m_text = text; }

    public Dictionary<string, object> Object() {
        var found = Value() as Dictionary<string, object>;
        EsmPackageException.Need(found != null && Next() == '\0', "its JSON is no object");
        return found;
    }

    /// <summary>The next character that is no blank, or 0 at the end.</summary>
    private char Next() {
        while (m_place < m_text.Length && " \t\r\n".IndexOf(m_text[m_place]) >= 0)
            ++m_place;
        return m_place < m_text.Length ? m_text[m_place] : '\0';
    }
    private bool Takes(char wanted) {
        if (Next() != wanted) return false;
        ++m_place;
        return true;
    }
    private void Need(bool condition) { EsmPackageException.Need(condition, "holds JSON that is damaged at character " + m_place); }

    private object Value() {
        Need(++m_depth < Deepest);
        char first = Next();
        object value = first == '{' ? Members() : first == '[' ? Elements() : first == '"' ? Text() : first == 't' ? Word("true", true)
                     : first == 'f' ? Word("false", false) : first == 'n' ? Word("null", null) : Number();
        --m_depth;
        return value;
    }

    private object Members() {
        var members = new Dictionary<string, object>();
        for (Takes('{'); !Takes('}');) {
            Need(members.Count == 0 || Takes(','));
            Next();
            string key = Text();
            Need(Takes(':'));
            members[key] = Value();
        }
        return members;
    }

    private object Elements() {
        var elements = new List<object>();
        for (Takes('['); !Takes(']');) {
            Need(elements.Count == 0 || Takes(','));
            elements.Add(Value());
        }
        return elements;
    }

    private string Text() {
        Need(Takes('"'));
        var text = new StringBuilder();
        for (;;) {
            Need(m_place < m_text.Length);
            char letter = m_text[m_place++];
            if (letter == '"') return text.ToString();
            text.Append(letter == '\\' ? Escaped() : letter);
        }
    }

    private char Escaped() {
        Need(m_place + 5 <= m_text.Length);
        char letter = m_text[m_place++];
        int known = "\"\\/bfnrt".IndexOf(letter);
        if (known >= 0) return "\"\\/\b\f\n\r\t"[known];
        Need(letter == 'u');
        m_place += 4;
        return (char)int.Parse(m_text.Substring(m_place - 4, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture);
    }

    private object Word(string word, object value) {
        Need(string.CompareOrdinal(m_text, m_place, word, 0, word.Length) == 0);
        m_place += word.Length;
        return value;
    }

    private object Number() {
        int begin = m_place;
        while (m_place < m_text.Length && "+-.0123456789eE".IndexOf(m_text[m_place]) >= 0)
            ++m_place;
        double number;
        Need(double.TryParse(m_text.Substring(begin, m_place - begin), NumberStyles.Float, CultureInfo.InvariantCulture, out number));
        return number;
    }
}

#if ESM_PACKAGE_PROGRAM
/// <summary>ORGAN.glb [Euler|Split STEPS SECONDS [force|lead NODE X Y Z]...]: says what it holds, or where forces on nodes, N, moved it
/// and its surface while other nodes were led evenly so far from rest, m.
/// --each FILE...: says of each what it holds, or what is wrong.</summary>
internal static class EsmPackageProgram {
    private static bool IsOfFile(Exception problem) {
        return problem is EsmPackageException || problem is IOException || problem is UnauthorizedAccessException;
    }

    private static string Summary(EsmPackage package) {
        return string.Format("{0} nodes, {1} springs, {2} hinges", package.NodeCount, package.Floats("springs", "restLength").Length,
                             package.Floats("hinges", "stiffness").Length);
    }

    private static int Each(IEnumerable<string> files) {
        foreach (string file in files)
            try {
                Console.WriteLine(Summary(EsmPackage.Read(file)));
            } catch (Exception problem) when (IsOfFile(problem)) {
                Console.WriteLine(file + ": " + problem.Message);
            }
        return 0;
    }

    private static void Print(IEnumerable<double> numbers) {
        Console.WriteLine(string.Join(" ", numbers.Select(number => number.ToString("R", CultureInfo.InvariantCulture))));
    }

    private static double[] Numbers(string[] arguments, int begin, int count) {
        return arguments.Skip(begin).Take(count).Select(text => double.Parse(text, CultureInfo.InvariantCulture)).ToArray();
    }

    private static void Run(EsmMotion motion, int steps, double seconds, string[] arguments) {
        double[] rest = motion.Positions.ToArray();
        for (int step = 1; step <= steps; ++step) {
            for (int i = 4; i + 4 < arguments.Length; i += 5) {
                uint node = uint.Parse(arguments[i + 1]);
                double[] numbers = Numbers(arguments, i + 2, 3);
                if (arguments[i] == "force")
                    motion.Forces[node] = numbers;
                else
                    motion.Led[node] = numbers.Select((number, axis) => rest[3 * node + axis] + (double)step / steps * number).ToArray();
            }
            motion.Step(seconds);
        }
    }

    private static int Main(string[] arguments) {
        if (arguments[0] == "--each") return Each(arguments.Skip(1));
        try {
            EsmPackage package = EsmPackage.Read(arguments[0]);
            Console.WriteLine(Summary(package));
            if (arguments.Length < 4) return 0;
            var motion = new EsmMotion(package, (EsmIntegrator)Enum.Parse(typeof(EsmIntegrator), arguments[1]));
            Run(motion, int.Parse(arguments[2]), Numbers(arguments, 3, 1)[0], arguments);
            Print(motion.Positions);
            Print(package.Carried(motion.Positions));
            return 0;
        } catch (Exception problem) when (IsOfFile(problem)) {
            Console.Error.WriteLine(arguments[0] + ": " + problem.Message);
            return 1;
        }
    }
}
#endif

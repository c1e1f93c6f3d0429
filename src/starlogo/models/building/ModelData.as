package starlogo.models.building
{
    import starlogo.data.textOf;
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.models.ModelTransform;
    import starlogo.models.SourceFrame;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.files.refuseModelIf;

    use namespace engine;

    /**
     * What a model is made of, as a record. First come the settings, then the content, then where it is from. The caller and the ModelReader of a format
     * fill it. A ModelBuilder brings the vertices to the model's place and scale. Then the Model keeps it.
     *
     * @private
     */
    public final class ModelData
    {
        /** The model's name. */
        public var name:String;

        /** The scaling: Model.FOOTPRINT, VOLUME or AS_GIVEN. A cooked file says it; otherwise the caller does. */
        public var scaling:String = null;

        /** Turns, scales and moves the model; null for none. The caller's, or the scale that the file's unit asks for. */
        public var transform:ModelTransform = null;

        /** The axis that points up in the vertices: "x", "y" or "z". They are turned to z up before the transform. */
        public var upAxis:String = "z";

        /** x, y, z of each vertex: as in the file, and then as in the model. */
        public var vertices:Vector.<Number> = new Vector.<Number>();

        /** Three vertex indices for each triangle. The ModelBuilder replaces an empty list by null. */
        public var triangles:Vector.<uint> = new Vector.<uint>();

        /** The material of each triangle. */
        public var materials:TriangleLabels = new TriangleLabels(new Vector.<String>());

        /** The mesh of each triangle. */
        public var meshes:TriangleLabels = new TriangleLabels(new Vector.<String>());

        /** The model's place and scale in its source. A ModelBuilder adds what it does to the vertices. */
        public var source:SourceFrame = new SourceFrame();

        /** Whether the vertices and the source are the model's own, as in some cooked files. Otherwise a ModelBuilder brings them to their places. */
        public var isInModelSpace:Boolean = false;

        /** The cooked file with the results for the model; null for none. */
        public var cooked:CookedFile = null;

        /** Data without vertices. */
        public function ModelData(name:String)
        {
            this.name = name || "";
        }

        /** Throws a ModelError if a scaling is none of Model's. */
        public static function requireScaling(name:String, scaling:String):void
        {
            refuseModelIf(Model.SCALINGS.indexOf(scaling) < 0, name, "the scaling must be Model.FOOTPRINT, VOLUME or AS_GIVEN, not \"" + scaling + "\"");
        }

        /** Throws a ModelError if an up axis is not "x", "y" or "z", or a ModelTransform in its place. */
        public static function requireUpAxis(name:String, upAxis:Object):void
        {
            refuseModelIf(["x", "y", "z"].indexOf(upAxis) < 0 && !(upAxis is ModelTransform), name, "the up axis must be \"x\", \"y\" or \"z\", or a ModelTransform, not "
                    + textOf(upAxis) + (Model.SCALINGS.indexOf(String(upAxis)) < 0 ? "" : ": a scaling is the argument after it"));
        }
    }
}

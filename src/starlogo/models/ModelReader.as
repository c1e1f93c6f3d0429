package starlogo.models
{
    import starlogo.data.textOf;
    import starlogo.engine;
    import starlogo.geometry.AffineTransform;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * Reads a model's file into a ModelData. Each format has a subclass, which adds the parts of the work. The last part is
     * <code>normalising()</code>. Only a pose of a glTF file is not normalised, and makes no model. A step takes about a millisecond, and
     * throws a ModelError if the file is wrong.
     *
     * @private
     */
    public class ModelReader extends StepSequence implements ModelMaker
    {
        // Reading the file is this share of the work. The rest is normalising.
        private static const READING:Number = 0.9;

        /** The model's data. It is complete when no step is left. */
        public var data:ModelData;

        private var _readShare:Number = 0;

        // Points without a surface. They become the model's vertices if there are no others.
        private var _loosePoints:Vector.<Number> = new Vector.<Number>();

        // The axis that points up in the file: "x", "y" or "z". "z" with a transform, which leaves the file as it is.
        private var _upAxis:String;

        /**
         * @param name the model's name
         * @param upAxis "x", "y", "z" or a ModelTransform
         * @param scaling as for Model's constructor; null if the file says it
         * @throws ModelError if the up axis is none of these
         */
        public function ModelReader(name:String, upAxis:Object, scaling:String)
        {
            data = new ModelData(name);
            data.scaling = scaling;
            data.transform = upAxis as ModelTransform;
            _upAxis = data.transform == null ? String(upAxis) : "z";
            refuseIf(_upAxis != "x" && _upAxis != "y" && _upAxis != "z", name,
                    "the up axis must be \"x\", \"y\" or \"z\", or a ModelTransform, not " + textOf(upAxis)
                    + (Model.SCALINGS.indexOf(_upAxis) < 0 ? "" : ": a scaling is the argument after it"));
        }

        /** Does all steps that are left. Returns the data. */
        public final function readAll():ModelData
        {
            finish(this);
            return data;
        }

        /** @inheritDoc */
        public final function get progress():Number
        {
            return READING * _readShare;
        }

        /** Notes how much of the file is read, from 0 to 1. */
        protected final function setReadShare(share:Number):void
        {
            _readShare = share;
        }

        /** @inheritDoc */
        public final function get model():Model
        {
            return new Model(null, null, null, null, data);
        }

        /** The model's name. */
        public final function get name():String
        {
            return data.name;
        }

        /** The list for a mesh's vertices: the model's vertices, or the points that have no surface. */
        protected final function verticesFor(hasSurface:Boolean):Vector.<Number>
        {
            return hasSurface ? data.vertices : _loosePoints;
        }

        /**
         * Takes the loose points if there are no vertices. Throws if there are no loose points either. @param expected for the error: what
         * the file must have
         */
        protected final function takeVertices(expected:String):void
        {
            data.vertices = data.vertices.length == 0 ? _loosePoints : data.vertices;
            refuseIf(data.vertices.length == 0, name, "no vertices: expected " + expected);
        }

        /** The steps that bring what is read to its place and scale. */
        protected final function normalising():Steps
        {
            return new Normalisation(data);
        }

        /** The steps that turn the vertices to z up. */
        protected final function turningToZUp():Steps
        {
            return _upAxis == "z" ? null : turnToZUp().transformingPoints(data.vertices);
        }

        /**
         * The turn to z up. If y is up, the file's -z becomes y. If x is up, -y becomes x and -z becomes y. (The COLLADA specification's
         * table for up_axis gives the right and inward axes.)
         *
         * @param fileAxis the axis that the file names; null for the one that the caller has named
         */
        protected final function turnToZUp(fileAxis:String = null):AffineTransform
        {
            switch (fileAxis || _upAxis)
            {
                case "x":
                    return new AffineTransform(new <Number>[0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0]);
                case "y":
                    return new AffineTransform(new <Number>[1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0]);
                default:
                    return new AffineTransform();
            }
        }
    }
}

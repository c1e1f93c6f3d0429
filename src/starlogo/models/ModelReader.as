package starlogo.models
{
    import starlogo.engine;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The work that makes a model from its file: the reader of its format fills the data, then a Normalisation brings these to their place
     * and scale. A step takes about a millisecond, and throws a ModelError if the file is wrong.
     *
     * @private
     */
    public final class ModelReader extends StepSequence implements ModelMaker
    {
        // Reading the file is this share of the work. The rest is normalising.
        private static const READING:Number = 0.9;

        private var _data:ModelData;

        /**
         * @param data what is read; see <code>dataFor()</code>
         * @param reading the steps that fill the data
         */
        public function ModelReader(data:ModelData, reading:Steps)
        {
            _data = data;
            add(reading).begin(normalising);
        }

        /**
         * The data of a file that is not read yet.
         *
         * @param name the model's name
         * @param upAxis "x", "y", "z" or a ModelTransform
         * @param scaling as for Model's constructor; null if the file says it
         * @throws ModelError if the up axis is none of these
         */
        public static function dataFor(name:String, upAxis:Object, scaling:String):ModelData
        {
            var data:ModelData = new ModelData(name);
            data.scaling = scaling;
            data.transform = upAxis as ModelTransform;
            requireUpAxis(name, upAxis, data.transform != null);
            data.upAxis = data.transform == null ? String(upAxis) : "z";
            return data;
        }

        /** Does all steps that are left. Returns the data, which are complete then. */
        public function readAll():ModelData
        {
            finish(this);
            return _data;
        }

        /** @inheritDoc */
        public function get name():String
        {
            return _data.name;
        }

        /** @inheritDoc */
        public function get progress():Number
        {
            return READING * _data.readShare;
        }

        /** @inheritDoc */
        public function get model():Model
        {
            return new Model(null, null, null, null, _data);
        }

        private function normalising():Steps
        {
            return new Normalisation(_data);
        }
    }
}

package starlogo.models
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedReader;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /** Makes a model's shape from a cooked file, in steps. No step throws. */
    internal final class CookedLoad extends StepSequence
    {
        /** Why there is no shape; null if there is one. Read it when no step is left. */
        public var problem:ModelError = null;

        private var _name:String;
        private var _asked:Fingerprint;
        private var _file:CookedFile;
        private var _reader:CookedReader = null;
        private var _shape:NormalisedShape = null;

        /**
         * @param name the model's name
         * @param bytes the bytes of a possible cooked file
         * @param asked the arguments for which the file must have been cooked; null for any
         */
        public function CookedLoad(name:String, bytes:ByteArray, asked:Fingerprint = null)
        {
            _name = name;
            _asked = asked;
            _file = new CookedFile(bytes);
            add(_file).begin(reading).begin(normalising);
        }

        /** @inheritDoc */
        override public function step():Boolean
        {
            try
            {
                return super.step();
            }
            catch (error:ModelError)
            {
                problem = error;
            }
            return false;
        }

        /** Gives the file's shape to a model. Call it when no step is left. @throws ModelError if there is a problem */
        public function giveTo(model:Model):Model
        {
            if (problem != null)
            {
                throw problem;
            }
            _shape.frame = _reader.frame || _shape.frame;
            model.setShape(_shape);
            model.cooked = _file;
            return model;
        }

        private function reading():Steps
        {
            refuseIf(_asked != null && _file.isWhole && !_file.isFor(_asked), _name, "the cooked file is for another up axis, transform or scaling");
            _reader = new CookedReader(_name, _file);
            return _reader;
        }

        private function normalising():Steps
        {
            var scaling:String = _reader.frame == null ? _reader.scaling : Model.AS_GIVEN;
            _shape = new NormalisedShape(_name, _reader.vertices, _reader.triangles, scaling, _reader.transform);
            return _shape;
        }
    }
}

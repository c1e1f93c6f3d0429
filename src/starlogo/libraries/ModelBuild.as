package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.geometry.GeometryFingerprint;
    import starlogo.libraries.cooked.FitsReader;
    import starlogo.libraries.cooked.FitsWriter;
    import starlogo.libraries.cooked.TreeReader;
    import starlogo.models.Model;
    import starlogo.solid.SolidHierarchy;
    import starlogo.solid.SolidHierarchyBuilder;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * Finds for one model what the libraries want of it, with their settings as they were when it began: what a baked file has,
     * or else what a store has, and what neither has is computed, and kept in the store.
     *
     * @private
     */
    public final class ModelBuild implements Steps
    {
        private var _model:Model;
        private var _structures:StructuresBuild = null;
        private var _hierarchy:SolidHierarchyBuilder = null;
        private var _settings:FitSettings;
        private var _baked:ByteArray;
        private var _store:FitStore;
        private var _geometry:GeometryFingerprint = null;
        private var _reader:FitsReader = null;
        private var _fits:ModelFits = new ModelFits();
        private var _work:StepSequence = new StepSequence();

        /**
         * @param model the model
         * @param structures finds its structures; null if none are wanted
         * @param hierarchies builds its hierarchy; null if none is wanted
         * @param baked what may be its .fits file; null for none
         * @param store null for none
         * @throws ArgumentError as the libraries' add do
         * @throws RangeError as HierarchiesLibrary.add does
         */
        public function ModelBuild(model:Model, structures:BoundingStructuresLibrary, hierarchies:HierarchiesLibrary, baked:ByteArray,
                store:FitStore)
        {
            _model = model;
            _baked = baked;
            _store = store;
            _settings = new FitSettings(structures, hierarchies);
            if (hierarchies != null)
            {
                _hierarchy = hierarchies.beginModel(model);
            }
            if (structures != null)
            {
                _structures = structures.begin(model.name, model.vertices);
            }
            if (baked != null || store != null)
            {
                _geometry = new GeometryFingerprint(model.vertices, model.triangles);
                _work.add(_geometry).begin(readBaked).begin(readStored).call(useFits);
            }
            if (_structures != null)
            {
                _work.add(_structures);
            }
            if (_hierarchy != null)
            {
                _work.begin(divide);
            }
            _work.call(keep);
        }

        /** The structures, when no step is left; null if none were wanted. */
        public function get structures():ShapeStructures
        {
            return _structures == null ? null : _structures.structures;
        }

        /** Whether the structures were known, when no step is left. */
        public function get areStructuresTaken():Boolean
        {
            return _structures != null && _structures.wasTaken;
        }

        /** What has the hierarchy, or makes it of what is known when it is needed, when no step is left; null if none was wanted. */
        public function get hierarchy():SolidHierarchyBuilder
        {
            return _hierarchy;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            return _work.step();
        }

        /** What a .fits file of the model has, the surface with it, when no step is left. Cost: that of the surface, if it is not prepared. */
        public function toFits():ByteArray
        {
            if (_hierarchy != null)
            {
                _hierarchy.finished.prepare();
            }
            return write();
        }

        private function readBaked():Steps
        {
            return _baked == null ? null : newReader(_baked);
        }

        private function readStored():Steps
        {
            takeRead();
            if (_store == null || isComplete)
            {
                return null;
            }
            var stored:ByteArray = _store.bytesOf(geometry, _settings);
            return stored == null ? null : newReader(stored);
        }

        private function useFits():void
        {
            takeRead();
            if (_structures != null && _fits.structures != null)
            {
                _structures.take(_fits.structures);
            }
            if (_hierarchy != null && _fits.tree != null)
            {
                _hierarchy.take(new TreeReader(_fits.tree), _fits.notes);
            }
        }

        // What was there before stays.
        private function takeRead():void
        {
            var read:ModelFits = _reader == null ? null : _reader.fits;
            _reader = null;
            if (read == null)
            {
                return;
            }
            _fits.structures ||= read.structures;
            if (_fits.tree == null || _fits.notes == null && read.notes != null)
            {
                _fits.tree = read.tree;
                _fits.notes = read.notes;
            }
        }

        private function get isComplete():Boolean
        {
            return (_structures == null || _fits.structures != null) && (_hierarchy == null || _fits.tree != null)
                && (!wantsSurface || _fits.notes != null);
        }

        private function get wantsSurface():Boolean
        {
            return _settings.wantsSurface && _model.triangles != null;
        }

        // What is known already waits until it is needed, unless all is to be prepared.
        private function divide():Steps
        {
            return _hierarchy.isTaken && !_settings.wantsSurface ? null : _hierarchy;
        }

        private function keep():void
        {
            var isNew:Boolean = _structures != null && !_structures.wasTaken || _hierarchy != null && !_hierarchy.isTaken
                || wantsSurface && _hierarchy.hierarchy.notes !== _fits.notes;
            if (_store != null && isNew && _store.mayHold(triangleCount || _model.vertices.length / 3))
            {
                _store.keep(geometry, _settings, write());
            }
        }

        private function write():ByteArray
        {
            var built:SolidHierarchy = _hierarchy == null ? null : _hierarchy.finished;
            return FitsWriter.write(ModelFits.of(structures, built), geometry, _settings);
        }

        private function newReader(bytes:ByteArray):FitsReader
        {
            _reader = new FitsReader(bytes, geometry, _settings, triangleCount);
            return _reader;
        }

        private function get triangleCount():int
        {
            return _model.triangles == null ? 0 : _model.triangles.length / 3;
        }

        private function get geometry():Fingerprint
        {
            if (_geometry == null)
            {
                _geometry = new GeometryFingerprint(_model.vertices, _model.triangles);
                finish(_geometry);
            }
            return _geometry.fingerprint;
        }
    }
}

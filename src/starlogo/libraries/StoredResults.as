package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Fingerprint;
    import starlogo.geometry.VertexBounds;
    import starlogo.libraries.cooked.CookedStructures;
    import starlogo.libraries.cooked.CookedTree;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedWriter;
    import starlogo.solid.ModelTree;
    import starlogo.solid.ModelTreeBuilder;
    import starlogo.solid.SurfaceTopology;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * The stored results for one model. Its steps take what is in the model's cooked file, otherwise what is in a store, and give it to the
     * builders that would compute it. When the builders have computed what is missing, it stores the results.
     *
     * @private
     */
    public final class StoredResults extends StepSequence
    {
        private var _model:Model;
        private var _structuresBuilder:StructuresBuilder;
        private var _treeBuilder:ModelTreeBuilder;
        private var _settings:FitSettings;
        private var _store:FitStore;

        // For the store: the fingerprint of the model's vertices and triangles, and whether all results have come from there.
        private var _geometry:Fingerprint = new Fingerprint();
        private var _isStored:Boolean = false;

        /**
         * @param model the model
         * @param structuresBuilder finds its structures; null if none are wanted. It has not begun
         * @param treeBuilder builds its hierarchy; null if none is wanted. It has not begun
         * @param settings the settings of the libraries that want them
         * @param store null for none
         */
        public function StoredResults(model:Model, structuresBuilder:StructuresBuilder, treeBuilder:ModelTreeBuilder, settings:FitSettings,
                store:FitStore)
        {
            _model = model;
            _structuresBuilder = structuresBuilder;
            _settings = settings;
            _treeBuilder = treeBuilder;
            if (model.data.cooked != null)
            {
                takeFrom(model.data.cooked);
            }
            _store = isComplete ? null : store;
            if (_store != null)
            {
                add(_geometry.addingGeometry(model.vertices, model.triangles)).begin(readingStored);
            }
        }

        /** Stores the results, unless all have come from the store. Call it when the builders have no step left. */
        public function store():void
        {
            var isKept:Boolean = _isStored && (_treeBuilder == null || _treeBuilder.isStored);
            if (_store != null && !isKept && _store.hasRoomFor(_model, _treeBuilder != null))
            {
                _store.keep(_geometry, _settings, newFile(_geometry, null));
            }
        }

        /**
         * Makes a cooked file of the model, including the surface. Call it when the builders have no step left. A surface that is missing is
         * prepared now.
         *
         * @param settings of the model's section: see <code>CookedFile.settingsOfLoad()</code>
         */
        public function toCooked(settings:Fingerprint):ByteArray
        {
            if (_treeBuilder != null)
            {
                _treeBuilder.finishTree().prepare();
            }
            return newFile(settings, CookedWriter.of(_model));
        }

        // The structures; null if they are not there yet, or are not wanted.
        private function get structures():ModelStructures
        {
            return _structuresBuilder == null ? null : _structuresBuilder.structures;
        }

        // Whether all results that are wanted are there.
        private function get isComplete():Boolean
        {
            return (_structuresBuilder == null || structures != null) && (_treeBuilder == null || _treeBuilder.isStored)
                && (!_settings.wantsSurface || _model.triangles == null || _treeBuilder.modelTree.surface != null);
        }

        // Takes results that are missing from a file. Whether the geometry is the model's is not checked, because the file's checksum
        // guarantees that.
        private function takeFrom(file:CookedFile):void
        {
            var size:Number = VertexBounds.of(_model.vertices).largest;
            if (size > VertexBounds.LARGEST_VERTEX)
            {
                // no fitter accepts such a model, so the record is wrong
                return;
            }
            if (_structuresBuilder != null && structures == null)
            {
                takeStructures(file, size);
            }
            if (_treeBuilder != null)
            {
                takeTree(file);
            }
        }

        // The file must have all structures that are wanted.
        private function takeStructures(file:CookedFile, size:Number):void
        {
            var found:Vector.<BoundingStructure> = CookedStructures.read(_settings.sectionOf(file, CookedFile.STRUCTURES), BoundingStructure.BOX, size);
            var hulls:Vector.<BoundingStructure> = _structuresBuilder.wantsHull
                ? CookedStructures.read(_settings.sectionOf(file, CookedFile.HULL), BoundingStructure.HULL, size) : null;
            if (found != null && (hulls != null || !_structuresBuilder.wantsHull))
            {
                // The smallest sphere may be in the hull's place.
                _structuresBuilder.useStored(found, hulls == null ? null : hulls[BoundingStructure.HULL] || hulls[BoundingStructure.SPHERE]);
            }
        }

        private function takeTree(file:CookedFile):void
        {
            var tree:ByteArray = _settings.sectionOf(file, CookedFile.HIERARCHY);
            var bytes:ByteArray = _settings.sectionOf(file, CookedFile.SURFACE);
            var surface:SurfaceTopology = bytes == null || _model.triangles == null ? null : SurfaceTopology.read(bytes, _model.triangles.length / 3);
            if (tree != null && (!_treeBuilder.isStored || surface != null && _treeBuilder.modelTree.surface == null))
            {
                _treeBuilder.useStored(new CookedTree(tree, _treeBuilder.modelTree.tree, _treeBuilder.maxDepth), surface);
            }
        }

        private function readingStored():Steps
        {
            var stored:CookedFile = _store.fileOf(_geometry, _settings);
            return new StepSequence().add(stored).call(function():void
                {
                    if (stored.isFor(_geometry))
                    {
                        takeFrom(stored);
                    }
                    _isStored = isComplete;
                });
        }

        // Makes a file of the results. The model's section has these settings and bytes; null if the file is for the store.
        private function newFile(settings:Fingerprint, model:ByteArray):ByteArray
        {
            var contents:Vector.<ByteArray> = new Vector.<ByteArray>(CookedFile.SECTIONS, true);
            contents[CookedFile.MODEL] = model;
            if (structures != null)
            {
                contents[CookedFile.STRUCTURES] = CookedStructures.write(structures.smallest);
                contents[CookedFile.HULL] = structures.hull == null ? null : CookedStructures.write(new <BoundingStructure>[structures.hull]);
            }
            if (_treeBuilder != null)
            {
                var made:ModelTree = _treeBuilder.finishTree();
                contents[CookedFile.HIERARCHY] = CookedTree.write(made.tree);
                if (made.isPrepared)
                {
                    contents[CookedFile.SURFACE] = CookedFile.newBytes();
                    made.surface.writeTo(contents[CookedFile.SURFACE]);
                }
            }
            return _settings.newFile(settings, contents);
        }
    }
}

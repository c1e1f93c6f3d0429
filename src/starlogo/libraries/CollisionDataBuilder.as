package starlogo.libraries
{
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.data.Fingerprint;
    import starlogo.engine;
    import starlogo.libraries.cooked.CookedStructures;
    import starlogo.libraries.cooked.CookedTree;
    import starlogo.models.Model;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedWriter;
    import starlogo.solid.ModelTree;
    import starlogo.solid.interior.SurfaceTopology;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * The work that builds the collision data of one model: its bounding structures, and the tree of its hierarchy with the surface. It takes what is
     * in the model's cooked file, otherwise what is in a store, and computes what is missing. Then it stores all. The constructor reads the cooked
     * file; the first steps read the store. A tree whose division is stored is not built until it is needed, unless its surface is wanted too.
     *
     * @private
     */
    public final class CollisionDataBuilder extends StepSequence
    {
        /** The structures, which are found when no step is left. Null if none are wanted. */
        public var structures:ModelStructures = null;

        /** The tree of the hierarchy; null if none is wanted. It may have no nodes yet when this work has no step left. */
        public var tree:ModelTree = null;

        private var _model:Model;

        // how often the model was posed before this work
        private var _poseCount:int;

        private var _settings:FitSettings;

        /**
         * @param model the model
         * @param structuresLibrary wants structures; null if none are wanted. Its settings count as they are now
         * @param hierarchiesLibrary wants a hierarchy; null if none is wanted. Its settings count as they are now
         * @param store null for none
         * @throws ArgumentError if a coordinate of the model is beyond 1e60
         */
        public function CollisionDataBuilder(model:Model, structuresLibrary:BoundingStructuresLibrary, hierarchiesLibrary:HierarchiesLibrary, store:FitStore)
        {
            _model = model;
            _poseCount = model.poseCount;
            ModelTable.requireCoordinates(model.name, model.vertices);
            _settings = new FitSettings(structuresLibrary, hierarchiesLibrary);
            tree = hierarchiesLibrary == null ? null : hierarchiesLibrary.newTree(model.vertices, model.triangles);
            structures = structuresLibrary == null ? null : new ModelStructures(model.vertices, structuresLibrary.hullFitter, structuresLibrary.keepAll);
            if (model.data.cooked != null)
            {
                takeFrom(model.data.cooked);
            }
            // made now, so that later changes of the fitters' settings do not count
            var fitting:Steps = areStructuresReady ? null : new StructuresFit(model.name, structures, structuresLibrary.fitters, structuresLibrary.keepHulls);
            if (store == null || isComplete)
            {
                add(computing(fitting));
            }
            else
            {
                addStoring(store, fitting);
            }
        }

        /** @inheritDoc @throws ArgumentError if the model was posed since this work was created, or as its parts */
        override public function step():Boolean
        {
            if (_model.poseCount != _poseCount)
            {
                throw ModelTable.errorOf(_model.name, "it was posed while it was being added: pose it before or afterwards");
            }
            return super.step();
        }

        /**
         * Makes a cooked file of the model, including the surface. Call it when no step is left. A surface that is missing is prepared now.
         *
         * @param modelKey the fingerprint of the arguments of the model's load: see <code>CookedFile.MODEL</code>
         */
        public function toCooked(modelKey:Fingerprint):ByteArray
        {
            if (tree != null)
            {
                tree.finishBuilding();
                tree.preparedInterior();
            }
            return bytesOf(modelKey, CookedWriter.write(_model));
        }

        // Whether the structures are found, or none are wanted.
        private function get areStructuresReady():Boolean
        {
            return structures == null || structures.tightest != null;
        }

        // Whether all data that is wanted is there, or stored.
        private function get isComplete():Boolean
        {
            return areStructuresReady && (tree == null || tree.restoring != null)
                && (!_settings.preparesExact || _model.triangles == null || tree.surface != null);
        }

        // Adds the work that takes data from a store, computes what it does not have, and stores all. @param fitting finds the structures
        private function addStoring(store:FitStore, fitting:Steps):void
        {
            var geometryKey:Fingerprint = new Fingerprint();
            var stored:CookedFile = null;
            var storesAll:Boolean = false;
            add(geometryKey.addingLists(_model.vertices, _model.triangles)).begin(function():Steps
                {
                    stored = store.readFile(geometryKey, _settings);
                    return stored;
                }).begin(function():Steps
                {
                    if (stored.hasKey(CookedFile.MODEL, geometryKey))
                    {
                        takeFrom(stored);
                    }
                    storesAll = !isComplete && store.hasRoomFor(_model, tree != null);
                    return computing(fitting);
                }).call(function():void
                {
                    if (!storesAll)
                    {
                        return;
                    }
                    // data that cannot be stored, or that reading refuses, is computed each time
                    var bytes:ByteArray = bytesOf(geometryKey, null);
                    if (stored.isChangedBy(bytes))
                    {
                        store.writeFile(geometryKey, _settings, bytes);
                    }
                });
        }

        // The work that computes what is missing. @param fitting finds the structures
        private function computing(fitting:Steps):Steps
        {
            var work:StepSequence = new StepSequence();
            if (!areStructuresReady)
            {
                work.add(fitting);
            }
            if (tree != null && (_settings.preparesExact || tree.restoring == null))
            {
                work.add(tree.building);
            }
            return work;
        }

        // Takes the data that is missing from a file of the model.
        private function takeFrom(file:CookedFile):void
        {
            if (!areStructuresReady)
            {
                takeStructures(file);
            }
            var division:ByteArray = _settings.sectionOf(file, CookedFile.HIERARCHY);
            if (division != null)
            {
                tree.restoring ||= new CookedTree(division, tree.boxTree, _settings.maxDepth);
            }
            var surface:ByteArray = division == null || _model.triangles == null ? null : _settings.sectionOf(file, CookedFile.SURFACE);
            var topology:SurfaceTopology = surface == null ? null : SurfaceTopology.read(surface, _model.triangles.length / 3);
            if (topology != null)
            {
                tree.surface = topology;
            }
        }

        // Takes the structures in a file, if it has all that are wanted. The smallest sphere may be in the hull's place.
        private function takeStructures(file:CookedFile):void
        {
            var found:Vector.<BoundingStructure> = CookedStructures.read(_settings.sectionOf(file, CookedFile.STRUCTURES), BoundingStructure.BOX, _model.vertices);
            var hulls:Vector.<BoundingStructure> = CookedStructures.read(_settings.sectionOf(file, CookedFile.HULL), BoundingStructure.HULL, _model.vertices);
            var hull:BoundingStructure = hulls == null ? null : hulls[BoundingStructure.HULL] || hulls[BoundingStructure.SPHERE];
            if (found != null && (hulls != null || !_settings.storesHull))
            {
                structures.setAll(found, hull);
            }
        }

        // The bytes of a file with the data. It has the surface if that is prepared. @param modelBytes those of the model; null for none
        private function bytesOf(modelKey:Fingerprint, modelBytes:ByteArray):ByteArray
        {
            var sections:Vector.<ByteArray> = new Vector.<ByteArray>(CookedFile.SECTION_COUNT, true);
            sections[CookedFile.MODEL] = modelBytes;
            if (structures != null)
            {
                sections[CookedFile.STRUCTURES] = CookedStructures.write(structures.smallest);
                sections[CookedFile.HULL] = CookedStructures.write(new <BoundingStructure>[structures.hullOrSphere]);
            }
            if (tree != null)
            {
                // its division may have come from a cooked model
                tree.finishBuilding();
                sections[CookedFile.HIERARCHY] = CookedTree.write(tree.boxTree);
                if (tree.isExactPrepared)
                {
                    sections[CookedFile.SURFACE] = CookedFile.newBytes();
                    tree.surface.writeTo(sections[CookedFile.SURFACE]);
                }
            }
            return CookedFile.write(_settings.keysWith(modelKey), sections);
        }
    }
}

// This room has what was computed for each model. A ModelTable has a ModelEntry for each name, and the two libraries show clients a part of it.
// CollisionDataBuilder takes the data from a cooked file or a FitStore (CookedStructures, CookedTree), or has the libraries compute it. Read this file
// first, then BoundingStructuresLibrary and CollisionDataBuilder.
package starlogo.libraries
{
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * The data under the name of one shape.
     *
     * @private
     */
    public final class ModelEntry
    {
        /**
         * Increased whenever data under this name is added, replaced, removed or posed. Read only.
         */
        public var revision:int = 0;

        /** The model; null if none was added. Read only. */
        public var model:Model = null;

        /** The structures; null if there are none. Read only. */
        public var structures:ModelStructures = null;

        /** The tree whose nodes are the hierarchy, which may not be built yet; null if there is none. Read only. */
        public var tree:ModelTree = null;

        /** Why the last load of a model of this name failed, or that it was cancelled; null if it did not, or if another one has begun or come. Read only. */
        public var loadProblem:String = null;

        private var _table:ModelTable;
        private var _loadingCount:int = 0;

        /** @param table counts the changes of all shapes */
        public function ModelEntry(table:ModelTable)
        {
            _table = table;
        }

        /** The tree; null if there is none. If it is not built yet, builds it. */
        public function builtTree():ModelTree
        {
            if (tree != null)
            {
                tree.finishBuilding();
            }
            return tree;
        }

        /**
         * Replaces everything under this name.
         *
         * @param model null for none
         * @param structures null for none
         * @param tree may not be built yet; null for none
         */
        public function replace(model:Model, structures:ModelStructures, tree:ModelTree):void
        {
            loadProblem = null;
            this.structures = structures;
            this.tree = tree;
            if (this.model != null)
            {
                this.model.removeListener(followPose);
            }
            this.model = model;
            if (model != null)
            {
                model.addListener(followPose);
            }
            countChange();
        }

        /** Counts one more model of this name that is loading. */
        public function expect():void
        {
            _loadingCount++;
            loadProblem = null;
        }

        /** Counts one less, if one is loading. @param problem why its load failed; null if it did not, and then it was cancelled unless there is a model */
        public function expectNoMore(problem:String):void
        {
            _loadingCount = Math.max(0, _loadingCount - 1);
            if (problem != null || model == null)
            {
                loadProblem = problem || "it was cancelled";
            }
        }

        /** Whether a model of this name is loading. */
        public function get isLoading():Boolean
        {
            return _loadingCount > 0;
        }

        private function followPose():void
        {
            // a hierarchy that a game has made of other vertices stays as it is
            if (tree != null && tree.boxTree.vertices == model.vertices)
            {
                tree.refit();
            }
            countChange();
        }

        private function countChange():void
        {
            revision++;
            _table.revision++;
        }
    }
}

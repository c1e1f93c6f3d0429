// This room has what was computed for each model. A ModelTable has a ModelEntry for each name, and the two libraries show clients a part of it;
// ModelResults takes the results from a cooked file or a FitStore, or has a StructuresBuilder and a BoxTreeBuilder compute them. Read this
// file first, then BoundingStructuresLibrary and ModelResults.
package starlogo.libraries
{
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.models.PoseListener;
    import starlogo.solid.ModelTree;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * The data under the name of one shape.
     *
     * @private
     */
    public final class ModelEntry implements PoseListener
    {
        /** The number of models of this name that are loading. */
        public var loadingCount:int = 0;

        /** The number of times that data under this name was replaced, removed or posed. */
        public var revision:int = 0;

        /** The model; null if none was added. Set it with setModel(). */
        public var model:Model = null;

        /** The structures; null if there are none. Set them with setStructures(). */
        public var structures:ModelStructures = null;

        private var _table:ModelTable;

        // The tree, or null; and the work that makes it when it is first needed, null if it is made.
        private var _tree:ModelTree = null;
        private var _building:Steps = null;

        /** @param table counts replaced and removed data of all shapes */
        public function ModelEntry(table:ModelTable)
        {
            _table = table;
        }

        /** Whether there is a hierarchy. Its tree may not be built yet. */
        public function get hasTree():Boolean
        {
            return _tree != null;
        }

        /** The tree whose nodes are the hierarchy; null if there is none. If it is not built yet, builds it. */
        public function builtTree():ModelTree
        {
            if (_building != null)
            {
                finish(_building);
                _building = null;
            }
            return _tree;
        }

        /** Sets the model; null for none. */
        public function setModel(value:Model):void
        {
            countChange(model);
            if (model != null)
            {
                model.removeListener(this);
            }
            model = value;
            if (model != null)
            {
                model.addListener(this);
            }
        }

        /** @inheritDoc */
        public function onPose():void
        {
            if (hasTree)
            {
                _tree.refit();
            }
            countChange(model);
        }

        /** Sets the structures; null for none. */
        public function setStructures(value:ModelStructures):void
        {
            countChange(structures);
            structures = value;
        }

        /** Sets the tree; null for none. @param building makes it when it is first needed; null if it is made */
        public function setTree(tree:ModelTree, building:Steps = null):void
        {
            countChange(_tree);
            _tree = tree;
            _building = building;
        }

        private function countChange(before:Object):void
        {
            if (before != null)
            {
                revision++;
                _table.revision++;
            }
        }
    }
}

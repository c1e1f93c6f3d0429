package docs
{
    import flash.display.Stage;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import support.TestStage;

    /**
     * What the samples of a page may name without showing it: the game of the README's first sample. A page that needs more has a class of its
     * own, which extends this one.
     */
    public class Page
    {
        public static const FIXTURES:Array = [];

        protected var greatLand:GreatLand = new GreatLand();
        protected var bear:Agent = new Agent("sphere", "bears");
        protected var ball:Agent = new Agent("sphere", "paintballs");
        protected var agents:Vector.<Agent> = new <Agent>[bear, ball];
        protected var collision:Collision = new Collision(new TightestFitCollider(greatLand));
        protected var stage:Stage = TestStage.stage;

        public function Page()
        {
            greatLand.addModel(BuiltInModel.sphere());
            ball.size = 0.2;
        }

        /**
         * Whether the samples have done what the page says.
         *
         * @param shown the variables that they declare
         */
        protected function check(shown:Object):void
        {
        }
    }
}

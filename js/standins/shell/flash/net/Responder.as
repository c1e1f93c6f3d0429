package flash.net
{
    /** Is never told of anything: FlexUnit names it. */
    public class Responder
    {
        public function Responder(result:Function, status:Function = null)
        {
        }
    }
}
